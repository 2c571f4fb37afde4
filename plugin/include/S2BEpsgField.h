// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <optional>

//! The coordinate system of an IFC file that is to be written, wherever the window writes one
/** Begins with the code of last time. **/
class S2BEpsgField : public QLineEdit
{
	Q_OBJECT

  public:
	explicit S2BEpsgField(QWidget* parent = nullptr);

	//! Takes what was typed; says why, and leads there, when it is no code
	bool check();
	//! What check() took: nothing when the field was empty
	std::optional<int> code() const
	{
		return m_code;
	}
	//! Next time begins with what check() took
	void remember() const;

  private:
	std::optional<int> m_code;
};
