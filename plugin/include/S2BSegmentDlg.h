// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>

class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QRadioButton;

//! Segment...: the model, and what it says about itself
/** What was chosen is remembered. **/
class S2BSegmentDlg : public QDialog
{
	Q_OBJECT

  public:
	//! \param subject what is segmented
	//! \param hasColors whether a model that needs colours can be used
	S2BSegmentDlg(const QString& subject, bool hasColors, QWidget* parent);

	//! The model's file; empty for the shipped one
	QString modelPath() const;

  private:
	void browse();
	void updateModel();
	void readSettings();
	void writeSettings() const;

	bool              m_hasColors;
	QRadioButton*     m_shipped = nullptr;
	QRadioButton*     m_own     = nullptr;
	QLineEdit*        m_path    = nullptr;
	QPushButton*      m_browse  = nullptr;
	QLabel*           m_model   = nullptr;
	QLabel*           m_hint    = nullptr;
	QDialogButtonBox* m_buttons = nullptr;
};
