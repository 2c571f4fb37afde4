// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "S2BInput.h"
#include "core/pipeline/level_survey.h"

#include <QFutureWatcher>
#include <QWidget>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;
class S2BLevelView;
class ccPointCloud;

//! The storeys that a run would find, found in the background when the page is opened, to look at and to correct
/** The clouds are read in a worker thread: they have to outlive the page and must not change meanwhile. **/
class S2BLevelPage : public QWidget
{
	Q_OBJECT

  public:
	//! What decides on the storeys; asked for whenever the page is opened
	struct Request
	{
		s2b::PipelineOptions options;
		s2b::LabelChoice     labels;
	};

	S2BLevelPage(std::vector<const ccPointCloud*> clouds, std::function<Request()> request, QWidget* parent = nullptr);
	~S2BLevelPage() override;

	//! The storeys as the user set them; empty when they are to be found
	std::vector<s2b::StoreyHeights> given() const;

	//! Looks again if anything that decides on the storeys was changed
	void refresh();

  protected:
	void showEvent(QShowEvent* event) override;

  private:
	struct Work;

	void start();
	void finish();
	void stop();
	void setStoreys(const std::vector<s2b::StoreyHeights>& storeys, bool areCorrected);
	void fillTable();
	void readTable(int row, int column);
	void addStorey();
	void removeStorey();
	void say(const QString& text);

	std::vector<const ccPointCloud*> m_clouds;
	std::function<Request()>         m_request;
	QString                          m_lastKey; //!< of the request that was answered last
	std::vector<s2b::StoreyHeights>  m_found;
	bool                             m_areCorrected = false;
	std::shared_ptr<Work>            m_work;
	QFutureWatcher<void>             m_watcher;

	S2BLevelView* m_view     = nullptr;
	QTableWidget* m_table    = nullptr;
	QLabel*       m_hint     = nullptr;
	QProgressBar* m_progress = nullptr;
	QPushButton*  m_add      = nullptr;
	QPushButton*  m_remove   = nullptr;
	QPushButton*  m_reset    = nullptr;
};
