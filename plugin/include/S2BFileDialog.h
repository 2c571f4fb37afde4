// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace s2b
{
	//! What a file dialog is for
	struct FileQuestion
	{
		QString name;  //!< object name
		QString title; //!< of the window
		QString start; //!< folder or file that is proposed
		QString filter;
		QString suffix; //!< added to a name without one; empty: a file to read
	};

	//! The file that the user chose, empty when the dialog was cancelled
	QString askForFile(QWidget* parent, const FileQuestion& question);
} // namespace s2b
