// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pipeline/parameters.h"

#include <QWidget>
#include <functional>
#include <vector>

class QGridLayout;
class QToolButton;

//! Editors for the parameters of the table: value, unit, range and help as tool tip, and a button back to the default
class S2BParameterPanel : public QWidget
{
	Q_OBJECT

  public:
	//! \param names the rows to show, in this order; empty: all, grouped by stage
	/** The parameters have to outlive the panel. **/
	S2BParameterPanel(s2b::Parameters& parameters, const std::vector<std::string>& names, QWidget* parent = nullptr);

	//! Shows the values again after they were changed elsewhere
	void refresh();

	//! Shows only the parameters whose name or help has that text
	void setFilter(const QString& text);

  private:
	struct Row
	{
		QString               text; //!< what is searched
		QWidget*              box = nullptr;
		std::vector<QWidget*> widgets;
	};

	void addRow(QGridLayout& grid, const s2b::ParameterInfo& info, QWidget* box);

	s2b::Parameters&                   m_parameters;
	std::vector<std::function<void()>> m_refresh;
	std::vector<Row>                   m_rows;
};
