// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BFileDialog.h"

#include <QFileDialog>
#include <QFileInfo>

namespace s2b
{
	QString askForFile(QWidget* parent, const FileQuestion& question)
	{
		const bool  isToWrite = !question.suffix.isEmpty();
		const bool  isFolder  = QFileInfo(question.start).isDir();
		QFileDialog dialog(parent, question.title, isFolder ? question.start : QFileInfo(question.start).absolutePath(), question.filter);
		dialog.setObjectName(question.name);
		dialog.setOption(QFileDialog::DontUseNativeDialog, qEnvironmentVariableIsSet("S2B_PLAIN_DIALOGS")); // the tests' own hands
		dialog.setAcceptMode(isToWrite ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
		dialog.setFileMode(isToWrite ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
		dialog.setDefaultSuffix(question.suffix);
		if (!isFolder)
			dialog.selectFile(QFileInfo(question.start).fileName());
		return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().front() : QString();
	}
} // namespace s2b
