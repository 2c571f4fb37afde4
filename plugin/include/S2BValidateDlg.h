// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>
#include <QStringList>
#include <functional>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace s2b
{
	//! What the dialog was told
	struct ValidationChoice
	{
		QString     truthPath; //!< empty: the model against the points
		QStringList storeys;   //!< of the truth; empty: all
		int         tolerance = 30;
		QString     reportFolder; //!< empty: no report
		bool        opensReport = false;
	};
} // namespace s2b

//! Validate against BIM...: the ground truth, the tolerance and the report
/** What was chosen is remembered. **/
class S2BValidateDlg : public QDialog
{
	Q_OBJECT

  public:
	//! \param subject what is selected, for the title
	//! \param name    of the report's folder
	//! \param canDoWithoutTruth a model and points are selected: the truth may be left out
	S2BValidateDlg(const QString& subject, const QString& name, bool canDoWithoutTruth, QWidget* parent);

	s2b::ValidationChoice choice() const;

  private:
	QWidget* makePathRow(QLineEdit*& edit, const char* name, const std::function<void()>& browse);
	void     browseTruth();
	void     browseReport();
	void     updateButtons();
	void     readSettings(const QString& name);
	void     writeSettings() const;

	bool              m_canDoWithoutTruth = false;
	QLineEdit*        m_truth             = nullptr;
	QLineEdit*        m_storeys           = nullptr;
	QComboBox*        m_tolerance         = nullptr;
	QCheckBox*        m_writeReport       = nullptr;
	QLineEdit*        m_report            = nullptr;
	QCheckBox*        m_openReport        = nullptr;
	QLabel*           m_hint              = nullptr;
	QDialogButtonBox* m_buttons           = nullptr;
};
