// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "S2BInput.h"
#include "core/pipeline/pipeline.h"

#include <QDialog>
#include <QString>
#include <map>
#include <vector>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QSpinBox;
class QTreeWidget;
class S2BParameterPanel;
class ccPointCloud;

namespace s2b
{
	//! What the dialog was told
	struct RunChoice
	{
		PipelineOptions pipeline;
		LabelChoice     labels;
		QString         ifcPath; //!< empty: no file
		QString         schema  = "IFC4";
		unsigned        threads = 0;
		std::uint64_t   seed    = 1;
	};
} // namespace s2b

//! Reconstruct...: labels, what to look for and the parameters that matter in front, all others on the second page
/** What was chosen is remembered. **/
class S2BReconstructDlg : public QDialog
{
	Q_OBJECT

  public:
	S2BReconstructDlg(const std::vector<const ccPointCloud*>& clouds, QWidget* parent);

	s2b::RunChoice choice() const;

  private:
	QWidget* makeMainPage();
	QWidget* makeLabelBox();
	QWidget* makeStageBox();
	QWidget* makeFileBox();
	QWidget* makeExpertPage();
	void     updateClasses();
	void     updateButtons();
	void     browseLabelMap();
	void     browseIfc();
	void     loadParameters();
	void     saveParameters();
	void     readSettings();
	void     writeSettings() const;

	std::vector<const ccPointCloud*> m_clouds;
	s2b::Parameters                  m_parameters;
	s2b::LabelMap                    m_map;
	bool                             m_labelsFit = true;

	QComboBox*                       m_field   = nullptr;
	QComboBox*                       m_mapName = nullptr;
	QTreeWidget*                     m_classes = nullptr;
	QLabel*                          m_hint    = nullptr;
	std::map<s2b::Stage, QCheckBox*> m_stages;
	S2BParameterPanel*               m_front    = nullptr;
	S2BParameterPanel*               m_expert   = nullptr;
	QCheckBox*                       m_writeIfc = nullptr;
	QLineEdit*                       m_ifcPath  = nullptr;
	QComboBox*                       m_schema   = nullptr;
	QSpinBox*                        m_threads  = nullptr;
	QSpinBox*                        m_seed     = nullptr;
	QDialogButtonBox*                m_buttons  = nullptr;
};
