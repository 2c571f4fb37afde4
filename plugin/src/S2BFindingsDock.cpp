// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BFindingsDock.h"

#include "S2BFindings.h"
#include "S2BView.h"

#include <QAbstractItemModel>
#include <QApplication>
#include <QHeaderView>
#include <QLabel>
#include <QStyle>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <ccHObject.h>
#include <ccMainAppInterface.h>

namespace
{
	constexpr int kIdRole       = Qt::UserRole;
	constexpr int kSeverityRole = Qt::UserRole + 1;

	enum Column
	{
		Severity,
		Title,
		Element,
		Text
	};

	//! The first column shows an icon and is sorted by what it means
	class FindingItem : public QTreeWidgetItem
	{
	  public:
		using QTreeWidgetItem::QTreeWidgetItem;

		bool operator<(const QTreeWidgetItem& other) const override
		{
			const int column = treeWidget() ? treeWidget()->sortColumn() : 0;
			if (column != Severity)
				return QTreeWidgetItem::operator<(other);
			return data(Severity, kSeverityRole).toInt() < other.data(Severity, kSeverityRole).toInt();
		}
	};

	QStyle::StandardPixmap iconOf(s2b::Severity severity)
	{
		return severity == s2b::Severity::Error ? QStyle::SP_MessageBoxCritical : severity == s2b::Severity::Warning ? QStyle::SP_MessageBoxWarning
		                                                                                                             : QStyle::SP_MessageBoxInformation;
	}
} // namespace

S2BFindingsDock::S2BFindingsDock(ccMainAppInterface& app)
    : S2BDock(app, "S2BFindingsDock", "Scan to BIM: findings")
{
	m_title = new QLabel;
	m_title->setObjectName("findingsTitle");
	m_list = new QTreeWidget;
	m_list->setObjectName("findings");
	m_list->setHeaderLabels({"", "Finding", "Element", "What it means"});
	m_list->setRootIsDecorated(false);
	m_list->setAlternatingRowColors(true);
	m_list->setUniformRowHeights(true);
	m_list->setSortingEnabled(true);
	m_list->sortByColumn(Severity, Qt::DescendingOrder);
	m_list->header()->setStretchLastSection(true);
	m_list->setToolTip("A click takes the camera there and selects the label in the DB tree");
	connect(m_list, &QTreeWidget::itemClicked, this, &S2BFindingsDock::go);
	connect(m_list, &QTreeWidget::itemActivated, this, &S2BFindingsDock::go);

	auto* page   = new QWidget;
	auto* column = new QVBoxLayout(page);
	column->setContentsMargins(6, 4, 6, 4);
	column->addWidget(m_title);
	column->addWidget(m_list, 1);
	setWidget(page);
	fill();

	// Labels that people delete are no longer counted, of whichever model they are.
	auto* recount = new QTimer(this);
	recount->setSingleShot(true);
	recount->setInterval(0);
	connect(recount, &QTimer::timeout, this, [this]
	        {
		        if (m_app.dbRootObject() && s2b::recountFindings(*m_app.dbRootObject()))
			        s2b::redrawTree(m_app); });
	if (const QAbstractItemModel* model = s2b::treeModel(app))
		connect(model, &QAbstractItemModel::rowsRemoved, recount, qOverload<>(&QTimer::start));
}

void S2BFindingsDock::fill()
{
	m_list->clear();
	const ccHObject* model = subject();
	if (!model)
	{
		m_title->setText("Select a reconstructed model to see what was uncertain in it.");
		return;
	}
	int warnings = 0;
	m_list->setSortingEnabled(false);
	const std::vector<s2b::Finding> findings = s2b::findingsIn(*model);
	for (const s2b::Finding& finding : findings)
	{
		auto* item = new FindingItem(m_list, {QString(), finding.title, finding.element, finding.text});
		item->setIcon(Severity, style()->standardIcon(iconOf(finding.severity)));
		item->setData(Severity, kSeverityRole, static_cast<int>(finding.severity));
		item->setData(Severity, kIdRole, finding.id);
		item->setToolTip(Text, finding.text);
		warnings += finding.severity == s2b::Severity::Info ? 0 : 1;
	}
	m_list->setSortingEnabled(true);
	for (const int column : {Severity, Title, Element})
		m_list->resizeColumnToContents(column);
	m_title->setText(QString("<b>%1</b>: %2, %3 of them warnings").arg(model->getName().toHtmlEscaped()).arg(findings.size() == 1 ? QString("one finding") : QString("%1 findings").arg(findings.size())).arg(warnings));
}

void S2BFindingsDock::go(QTreeWidgetItem* item)
{
	ccHObject* label = item ? s2b::findEntity(m_app, item->data(Severity, kIdRole).toUInt()) : nullptr;
	if (!label)
		return;
	s2b::selectOnly(m_app, label);
	s2b::showFinding(m_app, *label);
}
