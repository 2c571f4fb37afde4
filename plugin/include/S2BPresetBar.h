// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pipeline/presets.h"

#include <QWidget>
#include <map>

class QComboBox;
class QLabel;
class QSettings;

//! The presets: one choice for the kind of building, one for the kind of survey
class S2BPresetBar : public QWidget
{
	Q_OBJECT

  public:
	//! The parameters have to outlive the bar
	explicit S2BPresetBar(s2b::Parameters& parameters, QWidget* parent = nullptr);

	//! Shows no preset: the parameters came from elsewhere
	void clear();

	void readSettings(const QSettings& settings);
	void writeSettings(QSettings& settings) const;

  Q_SIGNALS:
	//! A preset was chosen and changed the parameters; what it does not say stays as it was
	void applied();

  private:
	void apply();
	void showHint();

	s2b::Parameters&                       m_parameters;
	std::map<s2b::PresetKind, QComboBox*>  m_choices;
	std::map<s2b::PresetKind, std::string> m_applied; //!< names; empty: none
	QLabel*                                m_hint = nullptr;
};
