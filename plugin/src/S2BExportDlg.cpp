// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BExportDlg.h"

#include "S2BOptions.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QSettings>

namespace
{
	const QString kFolder = "qScanToBim/folder";
	const QString kEpsg   = "qScanToBim/epsg";
} // namespace

S2BExportDlg::S2BExportDlg(const QString& fileName, QWidget* parent)
    : QFileDialog(parent, "Export IFC", QSettings().value(kFolder, QDir::homePath()).toString(), "IFC4 (*.ifc);;IFC4X3_ADD2 (*.ifc)")
{
	setObjectName("S2BExportDialog");
	setOption(DontUseNativeDialog);
	setAcceptMode(AcceptSave);
	setDefaultSuffix("ifc");
	selectFile(fileName);

	m_epsg = new QLineEdit(QSettings().value(kEpsg).toString());
	m_epsg->setObjectName("epsg");
	m_epsg->setPlaceholderText("none: the site is placed in the cloud's coordinates");
	m_epsg->setToolTip("The code of the projected coordinate system of the cloud's coordinates, 25832 say: the file gets an IfcMapConversion instead of a site placement");
	m_epsg->setClearButtonEnabled(true);
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

void S2BExportDlg::accept()
{
	const QString text = m_epsg->text().trimmed();
	try
	{
		m_code = text.isEmpty() ? std::nullopt : std::optional<int>(s2b::epsgCode(text));
	}
	catch (const std::exception& e)
	{
		QMessageBox box(QMessageBox::Warning, "Scan to BIM", QString::fromUtf8(e.what()), QMessageBox::Ok, this);
		box.setObjectName("S2BMessage");
		box.exec();
		m_epsg->setFocus();
		m_epsg->selectAll();
		return;
	}
	QFileDialog::accept();
	if (result() != Accepted) // a folder was entered, or what is there is not to be replaced
		return;
	QSettings settings;
	settings.setValue(kFolder, QFileInfo(path()).absolutePath());
	if (m_code)
		settings.setValue(kEpsg, *m_code);
	else
		settings.remove(kEpsg);
}
