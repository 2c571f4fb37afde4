// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BEpsgField.h"

#include "S2BOptions.h"

#include <QMessageBox>
#include <QSettings>

namespace
{
	const QString kEpsg = "qScanToBim/epsg";
}

S2BEpsgField::S2BEpsgField(QWidget* parent)
    : QLineEdit(QSettings().value(kEpsg).toString(), parent)
{
	setObjectName("epsg");
	setPlaceholderText("none: the site is placed in the cloud's coordinates");
	setToolTip("The code of the projected coordinate system of the cloud's coordinates, 25832 say: the file gets an IfcMapConversion instead of a site placement");
	setClearButtonEnabled(true);
}

bool S2BEpsgField::check()
{
	const QString typed = text().trimmed();
	try
	{
		m_code = typed.isEmpty() ? std::nullopt : std::optional<int>(s2b::epsgCode(typed));
		return true;
	}
	catch (const std::exception& e)
	{
		QMessageBox box(QMessageBox::Warning, "Scan to BIM", QString::fromUtf8(e.what()), QMessageBox::Ok, window());
		box.setObjectName("S2BMessage");
		box.exec();
		setFocus();
		selectAll();
		return false;
	}
}

void S2BEpsgField::remember() const
{
	QSettings settings;
	if (m_code)
		settings.setValue(kEpsg, *m_code);
	else
		settings.remove(kEpsg);
}
