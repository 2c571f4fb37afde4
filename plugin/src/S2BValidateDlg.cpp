// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BValidateDlg.h"

#include "core/validation/validation.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

namespace
{
	const QString kSettings = "qScanToBim";

	QFileDialog::Options fileOptions()
	{
		return qEnvironmentVariableIsSet("S2B_PLAIN_DIALOGS") ? QFileDialog::DontUseNativeDialog : QFileDialog::Options();
	}
} // namespace

S2BValidateDlg::S2BValidateDlg(const QString& subject, const QString& name, bool canDoWithoutTruth, QWidget* parent)
    : QDialog(parent, Qt::Tool)
    , m_canDoWithoutTruth(canDoWithoutTruth)
{
	setObjectName("S2BValidateDlg");
	setWindowTitle("Scan to BIM: validate");

	auto* form = new QFormLayout;
	form->addRow("Ground truth", makePathRow(m_truth, "truth", [this]
	                                         { browseTruth(); }));
	m_truth->setToolTip("Any IFC2X3, IFC4 or IFC4X3 file, or the CV4AEC challenge's JSON");
	m_truth->setPlaceholderText(canDoWithoutTruth ? "none: the model is compared with the points alone" : "an IFC file");

	m_storeys = new QLineEdit;
	m_storeys->setObjectName("storeys");
	m_storeys->setPlaceholderText("all");
	m_storeys->setToolTip("Names of the truth's storeys to compare, separated by commas");
	form->addRow("Storeys", m_storeys);

	m_tolerance = new QComboBox;
	m_tolerance->setObjectName("tolerance");
	const s2b::validation::ValidationParams defaults;
	for (std::size_t i = 0; i < defaults.loaLimit_m.size(); ++i)
	{
		const int level = static_cast<int>(10 * (i + 1));
		m_tolerance->addItem(QString("LOA%1: 95 % within %2 mm").arg(level).arg(1000.0 * defaults.loaLimit_m[i], 0, 'g', 3), level);
	}
	m_tolerance->setToolTip("The level of accuracy (USIBD) that an element has to keep");
	form->addRow("Tolerance", m_tolerance);

	m_writeReport = new QCheckBox("Write a report");
	m_writeReport->setObjectName("writeReport");
	form->addRow("", m_writeReport);
	QWidget* folder = makePathRow(m_report, "report", [this]
	                              { browseReport(); });
	m_report->setToolTip("report.html, report.json, elements.csv and issues.bcf go there");
	form->addRow("Folder", folder);
	m_openReport = new QCheckBox("Open it when it is done");
	m_openReport->setObjectName("openReport");
	form->addRow("", m_openReport);

	m_hint = new QLabel;
	m_hint->setObjectName("hint");
	m_hint->setWordWrap(true);
	m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
	m_buttons->button(QDialogButtonBox::Ok)->setText("Validate");

	auto* column = new QVBoxLayout(this);
	column->addWidget(new QLabel("<b>" + subject.toHtmlEscaped() + "</b>"));
	column->addLayout(form);
	column->addWidget(m_hint);
	column->addStretch();
	column->addWidget(m_buttons);

	connect(m_buttons, &QDialogButtonBox::accepted, this, [this]
	        {
		        writeSettings();
		        accept(); });
	connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
	connect(m_truth, &QLineEdit::textChanged, this, &S2BValidateDlg::updateButtons);
	connect(m_report, &QLineEdit::textChanged, this, &S2BValidateDlg::updateButtons);
	connect(m_writeReport, &QCheckBox::toggled, this, [this, folder](bool isOn)
	        {
		        folder->setEnabled(isOn);
		        m_openReport->setEnabled(isOn);
		        updateButtons(); });
	readSettings(name);
	folder->setEnabled(m_writeReport->isChecked());
	m_openReport->setEnabled(m_writeReport->isChecked());
	updateButtons();
	resize(560, minimumSizeHint().height());
}

QWidget* S2BValidateDlg::makePathRow(QLineEdit*& edit, const char* name, const std::function<void()>& browse)
{
	auto* row    = new QWidget;
	auto* layout = new QHBoxLayout(row);
	layout->setContentsMargins(0, 0, 0, 0);
	edit = new QLineEdit;
	edit->setObjectName(name);
	auto* button = new QPushButton("Browse...");
	layout->addWidget(edit, 1);
	layout->addWidget(button);
	connect(button, &QPushButton::clicked, this, browse);
	return row;
}

void S2BValidateDlg::browseTruth()
{
	const QString path = QFileDialog::getOpenFileName(this, "Ground truth", QFileInfo(m_truth->text()).absolutePath(), "BIM (*.ifc *.json);;All files (*)", nullptr, fileOptions());
	if (!path.isEmpty())
		m_truth->setText(path);
}

void S2BValidateDlg::browseReport()
{
	const QString path = QFileDialog::getExistingDirectory(this, "Folder of the report", QFileInfo(m_report->text()).absolutePath(), fileOptions() | QFileDialog::ShowDirsOnly);
	if (!path.isEmpty())
		m_report->setText(path);
}

void S2BValidateDlg::updateButtons()
{
	const QString path = m_truth->text().trimmed();
	QString       hint;
	if (path.isEmpty() && !m_canDoWithoutTruth)
		hint = "Choose the model to compare with.";
	else if (!path.isEmpty() && !QFileInfo(path).isReadable())
		hint = "The ground truth does not exist or can't be read.";
	else if (m_writeReport->isChecked() && m_report->text().trimmed().isEmpty())
		hint = "Choose a folder for the report.";
	m_hint->setText(hint);
	m_buttons->button(QDialogButtonBox::Ok)->setEnabled(hint.isEmpty());
}

s2b::ValidationChoice S2BValidateDlg::choice() const
{
	s2b::ValidationChoice choice;
	choice.truthPath = m_truth->text().trimmed();
	for (const QString& storey : m_storeys->text().split(',', Qt::SkipEmptyParts))
		choice.storeys << storey.trimmed();
	choice.tolerance = m_tolerance->currentData().toInt();
	if (m_writeReport->isChecked())
		choice.reportFolder = m_report->text().trimmed();
	choice.opensReport = m_writeReport->isChecked() && m_openReport->isChecked();
	return choice;
}

void S2BValidateDlg::readSettings(const QString& name)
{
	QSettings settings;
	settings.beginGroup(kSettings);
	m_truth->setText(settings.value("validation/truth").toString());
	m_tolerance->setCurrentIndex(m_tolerance->findData(settings.value("validation/tolerance", s2b::validation::ValidationParams{}.tolerance)));
	m_writeReport->setChecked(settings.value("validation/writeReport", true).toBool());
	m_openReport->setChecked(settings.value("validation/openReport", true).toBool());
	m_report->setText(QDir(settings.value("folder", QDir::homePath()).toString()).filePath(name + "_report"));
}

void S2BValidateDlg::writeSettings() const
{
	QSettings settings;
	settings.beginGroup(kSettings);
	settings.setValue("validation/truth", m_truth->text().trimmed());
	settings.setValue("validation/tolerance", m_tolerance->currentData());
	settings.setValue("validation/writeReport", m_writeReport->isChecked());
	settings.setValue("validation/openReport", m_openReport->isChecked());
	if (m_writeReport->isChecked())
		settings.setValue("folder", QFileInfo(m_report->text().trimmed()).absolutePath());
}
