// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BValidationDock.h"

#include "S2BValidationTree.h"
#include "S2BView.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QSaveFile>
#include <QSettings>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QTableView>
#include <QTemporaryDir>
#include <QUrl>
#include <QVBoxLayout>
#include <array>
#include <ccHObject.h>
#include <ccMainAppInterface.h>

namespace
{
	constexpr int kIdRole   = Qt::UserRole;
	constexpr int kSortRole = Qt::UserRole + 1;

	struct ColumnInfo
	{
		const char* key; //!< of an element's meta data
		const char* title;
		bool        isNumber;
	};
	// The errors first: they are what a table is sorted by.
	const std::array<ColumnInfo, 13> kColumns{{
	    {"No.", "No.", true},
	    {"Verdict", "Verdict", false},
	    {"Class", "Class", false},
	    {"Name", "Name", false},
	    {"Storey", "Storey", false},
	    {"LOA", "LOA", false},
	    {"IoU", "IoU", true},
	    {"Error: centre", "Centre", true},
	    {"Error: axis ends", "Axis ends", true},
	    {"Error: thickness", "Thickness", true},
	    {"Error: height", "Height", true},
	    {"Points: RMS", "RMS of points", true},
	    {"Points: coverage", "Coverage", true},
	}};
	constexpr int                    kVerdict = 1;
	constexpr int                    kClass   = 2;

	const std::array<const char*, 4> kReportFiles{"report.html", "report.json", "elements.csv", "issues.bcf"};

	// One filter for each of two columns, and a text anywhere.
	class ElementFilter : public QSortFilterProxyModel
	{
	  public:
		using QSortFilterProxyModel::QSortFilterProxyModel;
		QString verdict;
		QString elementClass;
		QString text;

		void changed()
		{
			invalidateFilter();
		}

	  protected:
		bool filterAcceptsRow(int row, const QModelIndex& parent) const override
		{
			const auto textOf = [&](int column)
			{ return sourceModel()->index(row, column, parent).data().toString(); };
			if ((!verdict.isEmpty() && textOf(kVerdict) != verdict) || (!elementClass.isEmpty() && textOf(kClass) != elementClass))
				return false;
			for (int column = 0; !text.isEmpty() && column < sourceModel()->columnCount(); ++column)
			{
				if (textOf(column).contains(text, Qt::CaseInsensitive))
					return true;
			}
			return text.isEmpty();
		}
	};

	QStandardItem* makeItem(const ccHObject& element, const ColumnInfo& column)
	{
		const QString text = element.getMetaData(column.key).toString();
		auto*         item = new QStandardItem(text); // the model's
		item->setEditable(false);
		item->setData(element.getUniqueID(), kIdRole);
		item->setToolTip(element.getMetaData("Reason").toString());
		if (column.isNumber)
		{
			// "12.3 mm" sorts as 12.3; what was not measured comes last.
			bool         isNumber = false;
			const double value    = text.section(' ', 0, 0).toDouble(&isNumber);
			item->setData(isNumber ? value : 1.0e300, kSortRole);
			item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
		}
		else
			item->setData(text, kSortRole);
		return item;
	}

	void offerValues(QComboBox& box, const QString& all, const QStandardItemModel& model, int column)
	{
		const QString        old = box.currentText();
		const QSignalBlocker quiet(box);
		QStringList          values;
		for (int row = 0; row < model.rowCount(); ++row)
			values << model.item(row, column)->text();
		values.removeDuplicates();
		values.sort();
		box.clear();
		box.addItem(all);
		box.addItems(values);
		box.setCurrentIndex(std::max(0, box.findText(old)));
	}
} // namespace

S2BValidationDock::S2BValidationDock(ccMainAppInterface& app)
    : S2BDock(app, "S2BValidationDock", "Scan to BIM: validation")
{
	m_model = new QStandardItemModel(this);
	m_proxy = new ElementFilter(this);
	m_proxy->setSourceModel(m_model);
	m_proxy->setSortRole(kSortRole);
	m_table = new QTableView;
	m_table->setObjectName("elements");
	m_table->setModel(m_proxy);
	m_table->setSortingEnabled(true);
	m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
	m_table->setSelectionMode(QAbstractItemView::SingleSelection);
	m_table->setAlternatingRowColors(true);
	m_table->verticalHeader()->hide();
	m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
	m_table->horizontalHeader()->setStretchLastSection(true);
	connect(m_table, &QTableView::clicked, this, &S2BValidationDock::go);
	connect(m_table, &QTableView::activated, this, &S2BValidationDock::go);

	auto* page   = new QWidget;
	auto* column = new QVBoxLayout(page);
	column->setContentsMargins(6, 4, 6, 4);
	column->addWidget(makeFilters());
	column->addWidget(m_table, 1);
	setWidget(page);
	fill();
}

QWidget* S2BValidationDock::makeFilters()
{
	auto* bar = new QWidget;
	auto* row = new QHBoxLayout(bar);
	row->setContentsMargins(0, 0, 0, 0);
	m_title   = new QLabel;
	m_verdict = new QComboBox;
	m_class   = new QComboBox;
	m_search  = new QLineEdit;
	m_open    = new QPushButton("Open report");
	m_export  = new QPushButton("Export report...");
	m_verdict->setObjectName("verdictFilter");
	m_class->setObjectName("classFilter");
	m_search->setObjectName("search");
	m_open->setObjectName("openReport");
	m_export->setObjectName("exportReport");
	m_verdict->setSizeAdjustPolicy(QComboBox::AdjustToContents);
	m_class->setSizeAdjustPolicy(QComboBox::AdjustToContents);
	m_search->setPlaceholderText("Search");
	m_search->setClearButtonEnabled(true);
	m_search->setMaximumWidth(180);
	m_export->setToolTip("The report as page, JSON, CSV and BCF issues, in a folder of your choice");
	row->addWidget(m_title, 1);
	for (QWidget* widget : {static_cast<QWidget*>(m_verdict), static_cast<QWidget*>(m_class), static_cast<QWidget*>(m_search), static_cast<QWidget*>(m_open), static_cast<QWidget*>(m_export)})
		row->addWidget(widget);
	for (QComboBox* box : {m_verdict, m_class})
		connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, [this]
		        { applyFilters(); });
	connect(m_search, &QLineEdit::textChanged, this, [this]
	        { applyFilters(); });
	connect(m_open, &QPushButton::clicked, this, &S2BValidationDock::openReport);
	connect(m_export, &QPushButton::clicked, this, &S2BValidationDock::exportReport);
	return bar;
}

void S2BValidationDock::setValidation(const ccHObject* tree, s2b::KeptReport report)
{
	if (tree)
		m_reports[tree->getUniqueID()] = std::move(report);
	setSubject(tree);
}

void S2BValidationDock::fill()
{
	const ccHObject* tree = subject();
	m_model->clear();
	QStringList titles;
	for (const ColumnInfo& column : kColumns)
		titles << column.title;
	m_model->setHorizontalHeaderLabels(titles);
	ccHObject::Container elements;
	if (tree)
		tree->filterChildren(elements, true, CC_TYPES::MESH, true);
	for (const ccHObject* element : elements)
	{
		if (!element->hasMetaData("Verdict"))
			continue;
		QList<QStandardItem*> items;
		for (const ColumnInfo& column : kColumns)
			items << makeItem(*element, column);
		QStandardItem* verdict = items[kVerdict];
		// What the group says tells more: a false element is out of tolerance too.
		const QString group = element->getParent()->getName().section(" (", 0, 0).toLower();
		verdict->setText(group);
		verdict->setData(group, kSortRole);
		verdict->setData(s2b::verdictColor(*element), Qt::DecorationRole);
		m_model->appendRow(items);
	}
	offerValues(*m_verdict, "All verdicts", *m_model, kVerdict);
	offerValues(*m_class, "All classes", *m_model, kClass);
	m_table->sortByColumn(0, Qt::AscendingOrder);
	m_table->resizeColumnsToContents();
	applyFilters();
}

void S2BValidationDock::applyFilters()
{
	auto& filter        = static_cast<ElementFilter&>(*m_proxy);
	filter.verdict      = m_verdict->currentIndex() > 0 ? m_verdict->currentText() : QString();
	filter.elementClass = m_class->currentIndex() > 0 ? m_class->currentText() : QString();
	filter.text         = m_search->text().trimmed();
	filter.changed();
	const ccHObject* tree = subject();
	if (!tree)
		m_title->setText("Select a validation in the DB tree, or make one with Validate against BIM...");
	else
		m_title->setText(QString("<b>%1</b>: %2 of %3 elements").arg(tree->getName().toHtmlEscaped()).arg(m_proxy->rowCount()).arg(m_model->rowCount()));
	m_open->setEnabled(!reportFolder().isEmpty());
	m_export->setEnabled(!reportFolder().isEmpty());
}

void S2BValidationDock::go(const QModelIndex& index)
{
	ccHObject* element = s2b::findEntity(m_app, index.data(kIdRole).toUInt());
	if (!element)
		return;
	// What is hidden can't be looked at.
	for (ccHObject* entity = element; entity && entity != subject(); entity = entity->getParent())
		entity->setEnabled(true);
	s2b::selectOnly(m_app, element);
	s2b::lookAt(m_app, *element);
}

// Where the report of the subject is; of an earlier session only when the user chose its folder.
QString S2BValidationDock::reportFolder() const
{
	const ccHObject* tree = subject();
	if (!tree)
		return {};
	const auto    kept   = m_reports.find(tree->getUniqueID());
	const QString folder = kept != m_reports.end() ? kept->second.folder : tree->getMetaData(s2b::kReportKey).toString();
	return QFile::exists(QDir(folder).filePath(kReportFiles[0])) ? folder : QString();
}

void S2BValidationDock::openReport()
{
	const QString page = QDir(reportFolder()).absoluteFilePath(kReportFiles[0]);
	if (!QDesktopServices::openUrl(QUrl::fromLocalFile(page)))
		QMessageBox::information(this, "Scan to BIM", QString("There is no browser here: open the page '%1' with one.").arg(page));
}

void S2BValidationDock::exportReport()
{
	QSettings settings;
	settings.beginGroup("qScanToBim");
	QFileDialog dialog(m_app.getMainWindow(), "Export report to a folder", settings.value("folder").toString());
	dialog.setObjectName("S2BExportReport");
	dialog.setOption(QFileDialog::DontUseNativeDialog, qEnvironmentVariableIsSet("S2B_PLAIN_DIALOGS"));
	dialog.setFileMode(QFileDialog::Directory);
	dialog.setOption(QFileDialog::ShowDirsOnly);
	if (dialog.exec() != QDialog::Accepted)
		return;
	const QDir target(dialog.selectedFiles().front());
	const QDir source(reportFolder());
	target.mkpath(".");
	for (const char* name : kReportFiles)
	{
		QFile     from(source.filePath(name));
		QSaveFile to(target.filePath(name)); // all of it or nothing
		if (!from.open(QIODevice::ReadOnly) || !to.open(QIODevice::WriteOnly) || to.write(from.readAll()) < 0 || !to.commit())
		{
			QMessageBox::warning(m_app.getMainWindow(), "Scan to BIM", QString("'%1' can't be written: choose another folder.").arg(target.filePath(name)));
			return;
		}
	}
	m_app.dispToConsole("[S2B] wrote " + target.filePath(kReportFiles[0]));
}
