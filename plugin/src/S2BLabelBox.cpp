// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BLabelBox.h"

#include "S2BFileDialog.h"
#include "S2BSegment.h"

#include <QComboBox>
#include <QFile>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QSettings>
#include <QStandardItemModel>
#include <QTreeWidget>
#include <algorithm>
#include <ccPointCloud.h>
#include <map>

namespace
{
	const QString kFile = "From a file...";
	// Rows of the list of fields.
	constexpr int kGeometryRow = 0;
	constexpr int kModelRow    = 1;
	constexpr int kFirstField  = 2;
} // namespace

S2BLabelBox::S2BLabelBox(std::vector<const ccPointCloud*> clouds, QWidget* parent)
    : QGroupBox("Labels of the points", parent)
    , m_clouds(std::move(clouds))
    , m_map(s2b::builtInLabelMap("s2b"))
{
	auto* form = new QFormLayout(this);

	m_field = new QComboBox;
	m_field->setObjectName("labelField");
	m_field->addItem("None: from the geometry alone");
	m_field->addItem("Those of the shipped model, with the geometry");
	const ccPointCloud& first = *m_clouds.front();
	for (unsigned i = 0; i < first.getNumberOfScalarFields(); ++i)
		m_field->addItem(first.getScalarFieldName(static_cast<int>(i)));
	if (auto* rows = qobject_cast<QStandardItemModel*>(m_field->model()); rows && !s2b::hasShippedModel())
	{
		rows->item(kModelRow)->setEnabled(false);
		rows->item(kModelRow)->setToolTip("This build of the plugin brings no model with it: Segment... takes one from a file");
	}
	m_field->setToolTip("The scalar field that holds a class code for every point");
	form->addRow("Field", m_field);

	m_mapName = new QComboBox;
	m_mapName->setObjectName("labelMap");
	m_mapName->addItems({"s2b", "s3dis", "scannet", "asprs", kFile});
	m_mapName->setToolTip("What the codes mean: a built-in map, or a TOML file with a table [labels] of code = \"class\"");
	form->addRow("Meaning of the codes", m_mapName);

	m_classes = new QTreeWidget;
	m_classes->setObjectName("classes");
	m_classes->setHeaderLabels({"Code", "Class", "Points", "Share"});
	m_classes->setRootIsDecorated(false);
	m_classes->setAlternatingRowColors(true);
	m_classes->setSelectionMode(QAbstractItemView::NoSelection);
	m_classes->header()->setStretchLastSection(true);
	m_classes->setMinimumHeight(80);
	form->addRow(m_classes);

	m_hint = new QLabel;
	m_hint->setObjectName("hint");
	m_hint->setWordWrap(true);
	form->addRow(m_hint);

	connect(m_field, qOverload<int>(&QComboBox::currentIndexChanged), this, [this]
	        { update(); });
	connect(m_mapName, qOverload<int>(&QComboBox::activated), this, [this]
	        { browse(); });
}

s2b::LabelChoice S2BLabelBox::choice() const
{
	s2b::LabelChoice choice;
	choice.use     = m_field->currentIndex() >= kFirstField;
	choice.orModel = m_field->currentIndex() != kGeometryRow;
	choice.map     = m_map;
	if (choice.use)
		choice.field = m_field->currentText();
	return choice;
}

void S2BLabelBox::complain(const QString& text)
{
	m_fits = false;
	m_hint->setText(QString("<span style='color:#b00020'>%1</span>").arg(text));
}

void S2BLabelBox::update()
{
	m_classes->clear();
	m_hint->clear();
	m_fits              = true;
	const bool hasField = m_field->currentIndex() >= kFirstField;
	m_mapName->setEnabled(hasField);
	m_classes->setVisible(hasField);
	if (!hasField)
	{
		m_hint->setText(m_field->currentIndex() == kModelRow
		                    ? "The points get their classes from the model that the plugin brings, weighed against the geometry: about a second for a million points. Segment... shows them first."
		                    : "Labels make the result better: a classified cloud gives fewer mistakes with furniture and doors.");
		return Q_EMIT changed();
	}
	std::map<int, std::size_t> counts;
	std::size_t                points       = 0;
	bool                       hasFractions = false;
	for (const ccPointCloud* cloud : m_clouds)
	{
		bool isFractional = false;
		for (const auto& [code, count] : s2b::countCodes(*cloud, m_field->currentText(), isFractional))
			counts[code] += count;
		hasFractions = hasFractions || isFractional;
		points += cloud->size();
	}
	if (hasFractions)
	{
		complain("This field is not made of class codes: choose another one, or none.");
		return Q_EMIT changed();
	}
	int unknown = 0;
	for (const auto& [code, count] : counts)
	{
		const auto    known = m_map.classOfCode.find(code);
		const bool    isIn  = known != m_map.classOfCode.end();
		const QString name  = isIn ? QString::fromStdString(std::string(s2b::labelName(known->second))) : QString("not in this map");
		const double  share = 100.0 * static_cast<double>(count) / static_cast<double>(points);
		auto*         item  = new QTreeWidgetItem(m_classes, {QString::number(code), name, QLocale(QLocale::English).toString(static_cast<qulonglong>(count)), QString("%1 %").arg(share, 0, 'f', 1)});
		item->setTextAlignment(2, Qt::AlignRight);
		item->setTextAlignment(3, Qt::AlignRight);
		if (!isIn)
		{
			item->setForeground(1, QColor(0xb0, 0x00, 0x20));
			++unknown;
		}
	}
	if (unknown)
		complain(QString("%1 in this cloud have no class in the map '%2': choose another map.").arg(unknown == 1 ? QString("The codes of one class") : QString("%1 codes").arg(unknown), QString::fromStdString(m_map.name)));
	Q_EMIT changed();
}

void S2BLabelBox::browse()
{
	QString name = m_mapName->currentText();
	try
	{
		if (name == kFile)
		{
			name = s2b::askForFile(this, {"S2BLabelMap", "Label map", {}, "TOML (*.toml)", {}});
			if (name.isEmpty())
			{
				m_mapName->setCurrentText("s2b");
				name = "s2b";
			}
		}
		m_map = s2b::loadLabelMap(QFile::encodeName(name).toStdString());
	}
	catch (const std::exception& e)
	{
		QMessageBox::warning(this, "Scan to BIM", QString::fromUtf8(e.what()));
		m_mapName->setCurrentText("s2b");
		m_map = s2b::builtInLabelMap("s2b");
	}
	update();
}

void S2BLabelBox::readSettings(const QSettings& settings)
{
	const QString map = settings.value("labelMap", "s2b").toString();
	try
	{
		m_map = s2b::builtInLabelMap(map.toStdString());
		m_mapName->setCurrentText(map);
	}
	catch (const std::exception&)
	{
		// it was a file: that has to be chosen again
	}
	// The field of last time if this cloud has it, or the one that holds labels by custom, or what was chosen without any.
	int field = m_field->findText(settings.value("labelField").toString());
	if (field < kFirstField)
		field = m_field->findText(s2b::defaultLabelField(*m_clouds.front()));
	if (field < kFirstField)
		field = s2b::hasShippedModel() && settings.value("labelsOfModel", true).toBool() ? kModelRow : kGeometryRow;
	const QSignalBlocker quiet(m_field);
	m_field->setCurrentIndex(field);
	update();
}

void S2BLabelBox::writeSettings(QSettings& settings) const
{
	settings.setValue("labelField", m_field->currentIndex() >= kFirstField ? m_field->currentText() : QString());
	if (m_field->currentIndex() < kFirstField && s2b::hasShippedModel())
		settings.setValue("labelsOfModel", m_field->currentIndex() == kModelRow);
	settings.setValue("labelMap", m_mapName->currentText());
}
