// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/corrections/corrections.h"
#include "core/corrections/model.h"

#include <QWidget>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;

//! The name, the class and the dimensions of one element
class S2BElementForm : public QWidget
{
	Q_OBJECT

  public:
	explicit S2BElementForm(QWidget* parent = nullptr);

	//! Shows an element; without one (id 0, or one that is not there) nothing can be changed
	void show(const s2b::Model& model, s2b::ElementId id);

	QString name() const;

	//! The model with what was changed here, and nothing else
	/** \throws Error{BadParameter} for what the element can't be **/
	s2b::Model apply(s2b::Model model) const;

  private:
	struct Row
	{
		s2b::Measure    measure;
		QLabel*         label = nullptr;
		QDoubleSpinBox* value = nullptr;
		double          shown = 0.0; //!< a value that nobody touched is not set
	};

	s2b::ElementId   m_id;
	QLineEdit*       m_name = nullptr;
	QComboBox*       m_kind = nullptr;
	std::vector<Row> m_rows;
};

//! A box for a length in metres
QDoubleSpinBox* makeLengthBox(const char* name);
