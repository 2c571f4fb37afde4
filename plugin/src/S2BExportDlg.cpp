// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BExportDlg.h"

#include "S2BEpsgField.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QSettings>

namespace
{
	const QString kFolder = "qScanToBim/folder";
} // namespace

S2BExportDlg::S2BExportDlg(const QString& fileName, QWidget* parent)
    : QFileDialog(parent, "Export IFC", QSettings().value(kFolder, QDir::homePath()).toString(), "IFC4 (*.ifc);;IFC4X3_ADD2 (*.ifc)")
{
	setObjectName("S2BExportDialog");
	setOption(DontUseNativeDialog);
	setAcceptMode(AcceptSave);
	setDefaultSuffix("ifc");
	selectFile(fileName);

	m_epsg      = new S2BEpsgField;
	auto* label = new QLabel("EPSG code:");
	label->setBuddy(m_epsg);
	if (auto* grid = qobject_cast<QGridLayout*>(layout()))
	{
		const int row = grid->rowCount();
		grid->addWidget(label, row, 0);
		grid->addWidget(m_epsg, row, 1);
	}
}

QString S2BExportDlg::path() const
{
	return selectedFiles().front();
}

QString S2BExportDlg::schema() const
{
	return selectedNameFilter().section(' ', 0, 0);
}

std::optional<int> S2BExportDlg::epsg() const
{
	return m_epsg->code();
}

void S2BExportDlg::accept()
{
	if (!m_epsg->check())
		return;
	QFileDialog::accept();
	if (result() != Accepted) // a folder was entered, or what is there is not to be replaced
		return;
	QSettings().setValue(kFolder, QFileInfo(path()).absolutePath());
	m_epsg->remember();
}
