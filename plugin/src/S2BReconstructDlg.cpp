// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BReconstructDlg.h"

#include "S2BEpsgField.h"
#include "S2BFileDialog.h"
#include "S2BLabelBox.h"
#include "S2BLevelPage.h"
#include "S2BParameterPanel.h"
#include "S2BPresetBar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QSaveFile>
#include <QScrollArea>
#include <QSettings>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>
#include <ccPointCloud.h>

namespace
{
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
} // namespace

S2BReconstructDlg::S2BReconstructDlg(const std::vector<const ccPointCloud*>& clouds, QWidget* parent)
    : QDialog(parent, Qt::Tool)
    , m_clouds(clouds)
{
	setObjectName("S2BReconstructDlg");
	setWindowTitle("Scan to BIM: reconstruct");

	qulonglong points = 0;
	for (const ccPointCloud* cloud : m_clouds)
		points += cloud->size();
	auto* title = new QLabel(QString("<b>%1</b>, %2 points").arg(m_clouds.size() == 1 ? m_clouds.front()->getName().toHtmlEscaped() : QString("%1 clouds, taken together").arg(m_clouds.size()), QLocale(QLocale::English).toString(points)));

	m_tabs = new QTabWidget;
	m_tabs->setObjectName("tabs");
	m_tabs->addTab(makeMainPage(), "Reconstruction");
	m_levels = new S2BLevelPage(m_clouds, [this]
	                            { return S2BLevelPage::Request{choice().pipeline, choice().labels}; });
	m_tabs->addTab(m_levels, "Levels");
	m_tabs->addTab(makeExpertPage(), "All parameters");
	connect(m_tabs, &QTabWidget::currentChanged, this, &S2BReconstructDlg::refreshParameters);

	m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
	m_buttons->button(QDialogButtonBox::Ok)->setText("Reconstruct");
	connect(m_buttons, &QDialogButtonBox::accepted, this, &S2BReconstructDlg::accept);
	connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

	auto* column = new QVBoxLayout(this);
	column->addWidget(title);
	column->addWidget(m_tabs);
	column->addWidget(m_buttons);

	readSettings();
	updateButtons();
	resize(600, 800); // it can be made less high: the classes scroll
}

QWidget* S2BReconstructDlg::makeMainPage()
{
	auto* page   = new QWidget;
	auto* column = new QVBoxLayout(page);
	m_presets    = new S2BPresetBar(m_parameters);
	m_labels     = new S2BLabelBox(m_clouds);
	column->addWidget(m_presets);
	column->addWidget(m_labels, 1);
	column->addWidget(makeStageBox());
	connect(m_presets, &S2BPresetBar::applied, this, &S2BReconstructDlg::refreshParameters);
	connect(m_labels, &S2BLabelBox::changed, this, &S2BReconstructDlg::updateButtons);

	auto* box       = new QGroupBox("This building");
	auto* boxColumn = new QVBoxLayout(box);
	m_front         = new S2BParameterPanel(m_parameters, kFrontParameters);
	boxColumn->addWidget(m_front);
	column->addWidget(box);
	column->addWidget(makeFileBox());
	return page;
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
	auto* grid   = new QGridLayout(box);
	m_writeIfc   = new QCheckBox("Write IFC");
	m_ifcPath    = new QLineEdit;
	m_schema     = new QComboBox;
	m_epsg       = new S2BEpsgField;
	auto* label  = new QLabel("EPSG code:");
	auto* browse = new QPushButton("...");
	label->setBuddy(m_epsg);
	m_writeIfc->setObjectName("writeIfc");
	m_ifcPath->setObjectName("ifcPath");
	m_schema->setObjectName("schema");
	m_schema->addItems({"IFC4", "IFC4X3_ADD2"});
	browse->setMaximumWidth(32);
	grid->addWidget(m_writeIfc, 0, 0);
	grid->addWidget(m_ifcPath, 0, 1);
	grid->addWidget(browse, 0, 2);
	grid->addWidget(m_schema, 0, 3);
	grid->addWidget(label, 1, 0);
	grid->addWidget(m_epsg, 1, 1, 1, 3);
	for (QWidget* widget : std::initializer_list<QWidget*>{m_ifcPath, browse, m_schema, label, m_epsg})
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
	auto* search = new QLineEdit;
	m_expert     = new S2BParameterPanel(m_parameters, {});
	search->setObjectName("parameterSearch");
	search->setPlaceholderText("Search names and help");
	search->setClearButtonEnabled(true);
	connect(search, &QLineEdit::textChanged, m_expert, &S2BParameterPanel::setFilter);
	column->addWidget(search);
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
	load->setObjectName("loadParameters");
	save->setObjectName("saveParameters");
	connect(restore, &QPushButton::clicked, this, [this]
	        {
		        m_parameters = {};
		        m_presets->clear();
		        refreshParameters(); });
	return page;
}

void S2BReconstructDlg::refreshParameters()
{
	m_front->refresh();
	m_expert->refresh();
	m_levels->refresh();
}

void S2BReconstructDlg::updateButtons()
{
	if (!m_buttons) // still being built
		return;
	const bool hasFile = !m_writeIfc->isChecked() || !m_ifcPath->text().trimmed().isEmpty();
	m_buttons->button(QDialogButtonBox::Ok)->setEnabled(m_labels->fits() && hasFile);
}

void S2BReconstructDlg::browseIfc()
{
	const QString path = s2b::askForFile(this, {"S2BIfcFile", "Write IFC", m_ifcPath->text(), "IFC (*.ifc)", "ifc"});
	if (!path.isEmpty())
		m_ifcPath->setText(path);
}

// The folder of parameter files is remembered apart from that of the models.
void S2BReconstructDlg::loadParameters()
{
	QSettings     settings;
	const QString path = s2b::askForFile(this, {"S2BLoadParameters", "Load parameters", settings.value("qScanToBim/configFolder", QDir::homePath()).toString(), "TOML (*.toml)", {}});
	if (path.isEmpty())
		return;
	settings.setValue("qScanToBim/configFolder", QFileInfo(path).absolutePath());
	try
	{
		s2b::Parameters loaded; // what the file does not say is a default, as with -CONFIG
		s2b::loadConfig(loaded, QFile::encodeName(path).toStdString());
		m_parameters = loaded;
		m_presets->clear();
	}
	catch (const std::exception& e)
	{
		QMessageBox box(QMessageBox::Warning, "Scan to BIM", QString::fromUtf8(e.what()), QMessageBox::Ok, this);
		box.setObjectName("S2BMessage");
		box.exec();
	}
	refreshParameters();
}

void S2BReconstructDlg::saveParameters()
{
	QSettings     settings;
	const QString start = QDir(settings.value("qScanToBim/configFolder", QDir::homePath()).toString()).filePath("parameters.toml");
	const QString path  = s2b::askForFile(this, {"S2BSaveParameters", "Save parameters", start, "TOML (*.toml)", "toml"});
	if (path.isEmpty())
		return;
	settings.setValue("qScanToBim/configFolder", QFileInfo(path).absolutePath());
	const QByteArray text = QByteArray::fromStdString(s2b::configText(m_parameters));
	QSaveFile        file(path); // all of it or nothing
	if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
		QMessageBox::warning(this, "Scan to BIM", QString("'%1' can't be written.").arg(path));
}

void S2BReconstructDlg::accept()
{
	if (m_writeIfc->isChecked() && !m_epsg->check())
	{
		m_tabs->setCurrentIndex(0);
		m_epsg->setFocus();
		return;
	}
	writeSettings();
	QDialog::accept();
}

s2b::RunChoice S2BReconstructDlg::choice() const
{
	s2b::RunChoice choice;
	choice.pipeline.parameters   = m_parameters;
	choice.labels                = m_labels->choice();
	choice.pipeline.geometryOnly = !choice.labels.use && !choice.labels.orModel;
	choice.pipeline.stages       = {s2b::Stage::Levels};
	for (const auto& [stage, check] : m_stages)
	{
		if (check->isChecked() && check->isEnabled())
			choice.pipeline.stages.insert(stage);
	}
	if (m_levels)
		choice.pipeline.levels = m_levels->given();
	if (m_writeIfc->isChecked())
	{
		choice.ifcPath = m_ifcPath->text().trimmed();
		choice.epsg    = m_epsg->code();
	}
	choice.schema  = m_schema->currentText();
	choice.threads = static_cast<unsigned>(m_threads->value());
	choice.seed    = static_cast<std::uint64_t>(m_seed->value());
	return choice;
}
