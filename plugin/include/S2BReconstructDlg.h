// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "S2BInput.h"
#include "core/pipeline/pipeline.h"

#include <QDialog>
#include <QString>
#include <map>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QLineEdit;
class QSpinBox;
class QTabWidget;
class S2BEpsgField;
class S2BLabelBox;
class S2BLevelPage;
class S2BParameterPanel;
class S2BPresetBar;
class ccPointCloud;

namespace s2b
{
	//! What the dialog was told
	struct RunChoice
	{
		PipelineOptions    pipeline;
		LabelChoice        labels;
		QString            ifcPath; //!< empty: no file
		QString            schema = "IFC4";
		std::optional<int> epsg; //!< of the file
		unsigned           threads = 0;
		std::uint64_t      seed    = 1;
	};
} // namespace s2b

//! Reconstruct...: labels, what to look for and the parameters that matter in front, the levels on a page of their own, and
//! all parameters on the last
/** What was chosen is remembered. **/
class S2BReconstructDlg : public QDialog
{
	Q_OBJECT

  public:
	S2BReconstructDlg(const std::vector<const ccPointCloud*>& clouds, QWidget* parent);

	s2b::RunChoice choice() const;

	//! Stays open, and says why, when a file is to be written in no coordinate system that there is
	void accept() override;

  private:
	QWidget* makeMainPage();
	QWidget* makeStageBox();
	QWidget* makeFileBox();
	QWidget* makeExpertPage();
	void     updateButtons();
	void     browseIfc();
	void     loadParameters();
	void     saveParameters();
	void     refreshParameters();
	void     readSettings();
	void     writeSettings() const;

	std::vector<const ccPointCloud*> m_clouds;
	s2b::Parameters                  m_parameters;

	QTabWidget*                      m_tabs    = nullptr;
	S2BPresetBar*                    m_presets = nullptr;
	S2BLabelBox*                     m_labels  = nullptr;
	S2BLevelPage*                    m_levels  = nullptr;
	std::map<s2b::Stage, QCheckBox*> m_stages;
	S2BParameterPanel*               m_front    = nullptr;
	S2BParameterPanel*               m_expert   = nullptr;
	QCheckBox*                       m_writeIfc = nullptr;
	QLineEdit*                       m_ifcPath  = nullptr;
	QComboBox*                       m_schema   = nullptr;
	S2BEpsgField*                    m_epsg     = nullptr;
	QSpinBox*                        m_threads  = nullptr;
	QSpinBox*                        m_seed     = nullptr;
	QDialogButtonBox*                m_buttons  = nullptr;
};
