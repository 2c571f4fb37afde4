// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BSegmentDlg.h"

#include "S2BSegment.h"
#include "core/segmentation/shipped_model.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>

namespace
{
	const QString kSettings = "qScanToBim";
	constexpr int kWidth_px = 560;
} // namespace

S2BSegmentDlg::S2BSegmentDlg(const QString& subject, bool hasColors, QWidget* parent)
    : QDialog(parent, Qt::Tool)
    , m_hasColors(hasColors)
{
	setObjectName("S2BSegmentDlg");
	setWindowTitle("Scan to BIM: segment");

	m_shipped = new QRadioButton("The model that comes with the plugin");
	m_shipped->setObjectName("shipped");
	m_shipped->setEnabled(!s2b::shippedModel().empty());
	m_own = new QRadioButton("Another model");
	m_own->setObjectName("own");
	m_path = new QLineEdit;
	m_path->setObjectName("modelPath");
	m_path->setPlaceholderText("an ONNX file");
	m_path->setToolTip("An ONNX file whose metadata says which classes, cells and features it was trained with: see docs/segmentation.md");
	m_browse = new QPushButton("Browse...");

	auto* grid = new QGridLayout;
	grid->addWidget(m_shipped, 0, 0, 1, 3);
	grid->addWidget(m_own, 1, 0);
	grid->addWidget(m_path, 1, 1);
	grid->addWidget(m_browse, 1, 2);
	grid->setColumnStretch(1, 1);

	m_model = new QLabel;
	m_model->setObjectName("model");
	m_model->setWordWrap(true);
	m_hint = new QLabel;
	m_hint->setObjectName("hint");
	m_hint->setWordWrap(true);
	auto* result = new QLabel(QString("Every point gets a class and how sure it is, as the scalar fields \"%1\" and \"%2\" of the cloud; Reconstruct... uses them as labels.").arg(s2b::kClassField, s2b::kConfidenceField));
	result->setWordWrap(true);
	m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
	m_buttons->button(QDialogButtonBox::Ok)->setText("Segment");

	auto* column = new QVBoxLayout(this);
	column->addWidget(new QLabel("<b>" + subject.toHtmlEscaped() + "</b>"));
	column->addLayout(grid);
	column->addWidget(m_model);
	column->addWidget(m_hint);
	column->addWidget(result);
	column->addStretch();
	column->addWidget(m_buttons);

	readSettings();
	connect(m_buttons, &QDialogButtonBox::accepted, this, [this]
	        {
		        writeSettings();
		        accept(); });
	connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
	connect(m_own, &QRadioButton::toggled, this, &S2BSegmentDlg::updateModel);
	connect(m_path, &QLineEdit::textChanged, this, &S2BSegmentDlg::updateModel);
	connect(m_browse, &QPushButton::clicked, this, &S2BSegmentDlg::browse);
	resize(kWidth_px, 0);
	updateModel();
}

void S2BSegmentDlg::browse()
{
	const QFileDialog::Options options = qEnvironmentVariableIsSet("S2B_PLAIN_DIALOGS") ? QFileDialog::DontUseNativeDialog : QFileDialog::Options();
	const QString              path    = QFileDialog::getOpenFileName(this, "Segmentation model", QFileInfo(m_path->text()).absolutePath(), "ONNX (*.onnx);;All files (*)", nullptr, options);
	if (!path.isEmpty())
		m_path->setText(path);
}

// A model is opened to look at it: what does not fit is said before the work.
void S2BSegmentDlg::updateModel()
{
	m_path->setEnabled(m_own->isChecked());
	m_browse->setEnabled(m_own->isChecked());
	m_model->clear();
	m_hint->clear();
	QString    hint;
	const bool isFile = QFileInfo(modelPath()).isFile();
	if (m_own->isChecked() && !isFile)
		hint = modelPath().isEmpty() ? "Choose a model." : "The model does not exist.";
	else
	{
		try
		{
			const s2b::OnnxModel model = s2b::openModel(modelPath(), 1);
			m_model->setText(s2b::modelText(model));
			if (model.contract().colour == s2b::ColourUse::Required && !m_hasColors)
				hint = "This model needs colours, and the cloud has none.";
		}
		catch (const std::exception& e)
		{
			hint = QString::fromUtf8(e.what());
		}
	}
	if (!hint.isEmpty())
		m_hint->setText("<span style='color:#b00020'>" + hint.toHtmlEscaped() + "</span>");
	m_hint->setVisible(!hint.isEmpty());
	m_buttons->button(QDialogButtonBox::Ok)->setEnabled(hint.isEmpty());
	// Texts of another length need another height, or they are cut off.
	layout()->activate();
	resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
}

QString S2BSegmentDlg::modelPath() const
{
	return m_own->isChecked() ? m_path->text().trimmed() : QString();
}

void S2BSegmentDlg::readSettings()
{
	QSettings settings;
	settings.beginGroup(kSettings);
	m_path->setText(settings.value("segmentation/model").toString());
	const bool isOwn = settings.value("segmentation/own", false).toBool() || !m_shipped->isEnabled();
	(isOwn ? m_own : m_shipped)->setChecked(true);
}

void S2BSegmentDlg::writeSettings() const
{
	QSettings settings;
	settings.beginGroup(kSettings);
	settings.setValue("segmentation/model", m_path->text().trimmed());
	settings.setValue("segmentation/own", m_own->isChecked());
}
