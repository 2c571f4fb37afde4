// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BReconstructDlg.h"

#include "S2BParameterPanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QTabWidget>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <ccPointCloud.h>

namespace
{
	const QString kFile = "From a file...";

	// The ones that differ from building to building.
	const std::vector<std::string> kFrontParameters{
	    "levels.minimumRoomHeight",
	    "walls.minimumThickness",
	    "walls.maximumThickness",
	    "walls.defaultThickness",
	    "walls.defaultExternalThickness",
	    "walls.minimumLength",
	};

	struct StageName
	{
		s2b::Stage  stage;
		const char* key;
		const char* text;
	};
	const std::vector<StageName> kStages{
	    {s2b::Stage::Walls, "walls", "Walls"},
	    {s2b::Stage::Doors, "doors", "Doors"},
	    {s2b::Stage::Windows, "windows", "Windows"},
	    {s2b::Stage::Openings, "openings", "Plain openings"},
	    {s2b::Stage::Columns, "columns", "Columns"},
	    {s2b::Stage::Slabs, "slabs", "Slabs"},
	    {s2b::Stage::Spaces, "spaces", "Spaces"},
	};

	std::string localFile(const QString& path)
	{
		return path.toLocal8Bit().toStdString();
	}
} // namespace

S2BReconstructDlg::S2BReconstructDlg(const std::vector<const ccPointCloud*>& clouds, QWidget* parent)
    : QDialog(parent, Qt::Tool)
    , m_clouds(clouds)
    , m_map(s2b::builtInLabelMap("s2b"))
{
	setObjectName("S2BReconstructDlg");
	setWindowTitle("Scan to BIM: reconstruct");

	qulonglong points = 0;
	for (const ccPointCloud* cloud : m_clouds)
		points += cloud->size();
	auto* title = new QLabel(QString("<b>%1</b>, %2 points").arg(m_clouds.size() == 1 ? m_clouds.front()->getName().toHtmlEscaped() : QString("%1 clouds, taken together").arg(m_clouds.size()), QLocale(QLocale::English).toString(points)));

	auto* tabs = new QTabWidget;
	tabs->setObjectName("tabs");
	tabs->addTab(makeMainPage(), "Reconstruction");
	tabs->addTab(makeExpertPage(), "All parameters");
	connect(tabs, &QTabWidget::currentChanged, this, [this]
	        {
		        m_front->refresh();
		        m_expert->refresh(); });

	m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
	m_buttons->button(QDialogButtonBox::Ok)->setText("Reconstruct");
	connect(m_buttons, &QDialogButtonBox::accepted, this, [this]
	        {
		        writeSettings();
		        accept(); });
	connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

	auto* column = new QVBoxLayout(this);
	column->addWidget(title);
	column->addWidget(tabs);
	column->addWidget(m_buttons);

	readSettings();
	updateClasses();
	resize(560, 680);
}

QWidget* S2BReconstructDlg::makeMainPage()
{
	auto* page   = new QWidget;
	auto* column = new QVBoxLayout(page);
	column->addWidget(makeLabelBox(), 1);
	column->addWidget(makeStageBox());

	auto* box       = new QGroupBox("This building");
	auto* boxColumn = new QVBoxLayout(box);
	m_front         = new S2BParameterPanel(m_parameters, kFrontParameters);
	boxColumn->addWidget(m_front);
	column->addWidget(box);
	column->addWidget(makeFileBox());
	return page;
}

QWidget* S2BReconstructDlg::makeLabelBox()
{
	auto* box  = new QGroupBox("Labels of the points");
	auto* form = new QFormLayout(box);

	m_field = new QComboBox;
	m_field->setObjectName("labelField");
	m_field->addItem("None: from the geometry alone");
	const ccPointCloud& first = *m_clouds.front();
	for (unsigned i = 0; i < first.getNumberOfScalarFields(); ++i)
		m_field->addItem(first.getScalarFieldName(static_cast<int>(i)));
	m_field->setToolTip("The scalar field that holds a class code for every point");
	form->addRow("Field", m_field);

	m_mapName = new QComboBox;
	m_mapName->setObjectName("labelMap");
	m_mapName->addItems({"s2b", "s3dis", "scannet", "asprs", kFile});
	m_mapName->setToolTip("What the codes mean: a built-in map, or a TOML file with a table [labels] of code = \"class\"");
	form->addRow("Meaning of the codes", m_mapName);

	m_classes = new QTreeWidget;
	m_classes->setObjectName("classes");
	m_classes->setHeaderLabels({"Code", "Class", "Points"});
	m_classes->setRootIsDecorated(false);
	m_classes->setAlternatingRowColors(true);
	m_classes->setSelectionMode(QAbstractItemView::NoSelection);
	m_classes->header()->setStretchLastSection(true);
	m_classes->setMinimumHeight(110);
	form->addRow(m_classes);

	m_hint = new QLabel;
	m_hint->setObjectName("hint");
	m_hint->setWordWrap(true);
	form->addRow(m_hint);

	connect(m_field, qOverload<int>(&QComboBox::currentIndexChanged), this, [this]
	        { updateClasses(); });
	connect(m_mapName, qOverload<int>(&QComboBox::activated), this, [this]
	        { browseLabelMap(); });
	return box;
}

QWidget* S2BReconstructDlg::makeStageBox()
{
	auto* box  = new QGroupBox("Reconstruct");
	auto* grid = new QGridLayout(box);
	int   i    = 0;
	for (const StageName& stage : kStages)
	{
		auto* check = new QCheckBox(stage.text);
		check->setObjectName(QString("stage.") + stage.key);
		check->setChecked(true);
		grid->addWidget(check, i / 4, i % 4);
		m_stages[stage.stage] = check;
		++i;
	}
	// Openings and spaces can't be without walls.
	connect(m_stages[s2b::Stage::Walls], &QCheckBox::toggled, this, [this](bool on)
	        {
		        for (const s2b::Stage needs : {s2b::Stage::Doors, s2b::Stage::Windows, s2b::Stage::Openings, s2b::Stage::Spaces})
			        m_stages[needs]->setEnabled(on); });
	return box;
}

QWidget* S2BReconstructDlg::makeFileBox()
{
	auto* box    = new QGroupBox("File");
	auto* row    = new QHBoxLayout(box);
	m_writeIfc   = new QCheckBox("Write IFC");
	m_ifcPath    = new QLineEdit;
	m_schema     = new QComboBox;
	auto* browse = new QPushButton("...");
	m_writeIfc->setObjectName("writeIfc");
	m_ifcPath->setObjectName("ifcPath");
	m_schema->setObjectName("schema");
	m_schema->addItems({"IFC4", "IFC4X3_ADD2"});
	browse->setMaximumWidth(32);
	row->addWidget(m_writeIfc);
	row->addWidget(m_ifcPath, 1);
	row->addWidget(browse);
	row->addWidget(m_schema);
	for (QWidget* widget : {static_cast<QWidget*>(m_ifcPath), static_cast<QWidget*>(browse), static_cast<QWidget*>(m_schema)})
	{
		widget->setEnabled(false);
		connect(m_writeIfc, &QCheckBox::toggled, widget, &QWidget::setEnabled);
	}
	connect(m_writeIfc, &QCheckBox::toggled, this, [this]
	        { updateButtons(); });
	connect(m_ifcPath, &QLineEdit::textChanged, this, [this]
	        { updateButtons(); });
	connect(browse, &QPushButton::clicked, this, [this]
	        { browseIfc(); });
	return box;
}

QWidget* S2BReconstructDlg::makeExpertPage()
{
	auto* page   = new QWidget;
	auto* column = new QVBoxLayout(page);
	auto* scroll = new QScrollArea;
	m_expert     = new S2BParameterPanel(m_parameters, {});
	scroll->setWidget(m_expert);
	scroll->setWidgetResizable(true);
	scroll->setFrameShape(QFrame::NoFrame);
	column->addWidget(scroll, 1);

	auto* row     = new QHBoxLayout;
	m_threads     = new QSpinBox;
	m_seed        = new QSpinBox;
	auto* load    = new QPushButton("Load...");
	auto* save    = new QPushButton("Save...");
	auto* restore = new QPushButton("Defaults");
	m_threads->setRange(0, 1024);
	m_threads->setSpecialValueText("all");
	m_threads->setToolTip("Worker threads; the result does not depend on it");
	m_seed->setRange(0, 1000000);
	m_seed->setValue(1);
	m_seed->setToolTip("Of the random draws: the same seed gives the same model");
	load->setToolTip("Read parameters from a TOML file, as -CONFIG does");
	save->setToolTip("Write the parameters as a TOML file for -CONFIG");
	restore->setObjectName("defaults");
	row->addWidget(new QLabel("Threads"));
	row->addWidget(m_threads);
	row->addWidget(new QLabel("Seed"));
	row->addWidget(m_seed);
	row->addStretch();
	row->addWidget(load);
	row->addWidget(save);
	row->addWidget(restore);
	column->addLayout(row);
	connect(load, &QPushButton::clicked, this, [this]
	        { loadParameters(); });
	connect(save, &QPushButton::clicked, this, [this]
	        { saveParameters(); });
	connect(restore, &QPushButton::clicked, this, [this]
	        {
		        m_parameters = {};
		        m_expert->refresh();
		        m_front->refresh(); });
	return page;
}

void S2BReconstructDlg::updateClasses()
{
	m_classes->clear();
	m_hint->clear();
	m_labelsFit         = true;
	const bool hasField = m_field->currentIndex() > 0;
	m_mapName->setEnabled(hasField);
	m_classes->setVisible(hasField);
	if (!hasField)
	{
		m_hint->setText("Labels make the result better: a classified cloud gives fewer mistakes with furniture and doors.");
		updateButtons();
		return;
	}
	std::map<int, std::size_t> counts;
	for (const ccPointCloud* cloud : m_clouds)
	{
		bool hasFractions = false;
		for (const auto& [code, count] : s2b::countCodes(*cloud, m_field->currentText(), hasFractions))
			counts[code] += count;
		m_labelsFit = m_labelsFit && !hasFractions;
	}
	if (!m_labelsFit)
	{
		m_hint->setText("<span style='color:#b00020'>This field is not made of class codes: choose another one, or none.</span>");
		updateButtons();
		return;
	}
	int unknown = 0;
	for (const auto& [code, count] : counts)
	{
		const auto known = m_map.classOfCode.find(code);
		const bool isIn  = known != m_map.classOfCode.end();
		const auto name  = isIn ? QString::fromStdString(std::string(s2b::labelName(known->second))) : QString("not in this map");
		auto*      item  = new QTreeWidgetItem(m_classes, {QString::number(code), name, QLocale(QLocale::English).toString(static_cast<qulonglong>(count))});
		item->setTextAlignment(2, Qt::AlignRight);
		if (!isIn)
		{
			item->setForeground(1, QColor(0xb0, 0x00, 0x20));
			++unknown;
		}
	}
	m_labelsFit = unknown == 0;
	if (unknown)
		m_hint->setText(QString("<span style='color:#b00020'>%1 in this cloud have no class in the map '%2': choose another map.</span>").arg(unknown == 1 ? QString("The codes of one class") : QString("%1 codes").arg(unknown), QString::fromStdString(m_map.name)));
	updateButtons();
}

void S2BReconstructDlg::updateButtons()
{
	if (!m_buttons) // still being built
		return;
	const bool hasFile = !m_writeIfc->isChecked() || !m_ifcPath->text().trimmed().isEmpty();
	m_buttons->button(QDialogButtonBox::Ok)->setEnabled(m_labelsFit && hasFile);
}

void S2BReconstructDlg::browseLabelMap()
{
	QString name = m_mapName->currentText();
	try
	{
		if (name == kFile)
		{
			name = QFileDialog::getOpenFileName(this, "Label map", {}, "TOML (*.toml)");
			if (name.isEmpty())
			{
				m_mapName->setCurrentText("s2b");
				name = "s2b";
			}
		}
		m_map = s2b::loadLabelMap(localFile(name));
	}
	catch (const std::exception& e)
	{
		QMessageBox::warning(this, "Scan to BIM", QString::fromUtf8(e.what()));
		m_mapName->setCurrentText("s2b");
		m_map = s2b::builtInLabelMap("s2b");
	}
	updateClasses();
}

void S2BReconstructDlg::browseIfc()
{
	QString path = QFileDialog::getSaveFileName(this, "Write IFC", m_ifcPath->text(), "IFC (*.ifc)");
	if (path.isEmpty())
		return;
	if (!path.endsWith(".ifc", Qt::CaseInsensitive))
		path += ".ifc";
	m_ifcPath->setText(path);
}

void S2BReconstructDlg::loadParameters()
{
	const QString path = QFileDialog::getOpenFileName(this, "Load parameters", {}, "TOML (*.toml)");
	if (path.isEmpty())
		return;
	try
	{
		s2b::loadConfig(m_parameters, localFile(path));
	}
	catch (const std::exception& e)
	{
		QMessageBox::warning(this, "Scan to BIM", QString::fromUtf8(e.what()));
	}
	m_expert->refresh();
	m_front->refresh();
}

void S2BReconstructDlg::saveParameters()
{
	QString path = QFileDialog::getSaveFileName(this, "Save parameters", "parameters.toml", "TOML (*.toml)");
	if (path.isEmpty())
		return;
	QFile file(path);
	if (!file.open(QIODevice::WriteOnly) || file.write(s2b::configText(m_parameters).c_str()) < 0)
		QMessageBox::warning(this, "Scan to BIM", QString("'%1' can't be written.").arg(path));
}

s2b::RunChoice S2BReconstructDlg::choice() const
{
	s2b::RunChoice choice;
	choice.pipeline.parameters   = m_parameters;
	choice.pipeline.geometryOnly = m_field->currentIndex() <= 0;
	choice.pipeline.stages       = {s2b::Stage::Levels};
	for (const auto& [stage, check] : m_stages)
	{
		if (check->isChecked() && check->isEnabled())
			choice.pipeline.stages.insert(stage);
	}
	choice.labels.use = !choice.pipeline.geometryOnly;
	choice.labels.map = m_map;
	if (choice.labels.use)
		choice.labels.field = m_field->currentText();
	if (m_writeIfc->isChecked())
		choice.ifcPath = m_ifcPath->text().trimmed();
	choice.schema  = m_schema->currentText();
	choice.threads = static_cast<unsigned>(m_threads->value());
	choice.seed    = static_cast<std::uint64_t>(m_seed->value());
	return choice;
}
