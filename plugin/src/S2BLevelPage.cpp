// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BLevelPage.h"

#include "S2BLevelView.h"
#include "core/base/error.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStringList>
#include <QTableWidget>
#include <QVBoxLayout>
#include <QtConcurrent>
#include <algorithm>
#include <ccPointCloud.h>

// Shared with the worker, which may outlive the request but never the page.
struct S2BLevelPage::Work
{
	std::stop_source stop;
	s2b::LevelSurvey survey;
	QString          failure;
	bool             isDone = false;
};

namespace
{
	constexpr double kNewRoom_m = 2.6;
	constexpr double kNewSlab_m = 0.3;

	// Everything that the storeys depend on, as text.
	QString keyOf(const S2BLevelPage::Request& request)
	{
		QStringList key{request.labels.use ? request.labels.field : QString(), QString::fromStdString(request.labels.map.name)};
		for (const s2b::ParameterInfo& info : s2b::parameterTable())
		{
			const QString name = QString::fromStdString(info.name);
			for (const char* stage : {"clutter.", "cells.", "frame.", "levels."})
			{
				if (name.startsWith(stage))
					key << QString::number(info.value(request.options.parameters), 'g', 17);
			}
		}
		return key.join('|');
	}
} // namespace

S2BLevelPage::S2BLevelPage(std::vector<const ccPointCloud*> clouds, std::function<Request()> request, QWidget* parent)
    : QWidget(parent)
    , m_clouds(std::move(clouds))
    , m_request(std::move(request))
{
	setObjectName("levelPage");
	m_view  = new S2BLevelView;
	m_table = new QTableWidget(0, 2);
	m_table->setObjectName("storeys");
	m_table->setHorizontalHeaderLabels({"Floor [m]", "Ceiling [m]"});
	m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
	m_table->setMaximumHeight(150);
	m_table->setToolTip("Heights in world coordinates; double click to type one");
	m_hint = new QLabel;
	m_hint->setObjectName("levelHint");
	m_hint->setWordWrap(true);
	m_progress = new QProgressBar;
	m_progress->setRange(0, 0);
	m_progress->setTextVisible(false);
	m_progress->setMaximumHeight(6);
	m_add    = new QPushButton("Add storey");
	m_remove = new QPushButton("Remove storey");
	m_reset  = new QPushButton("As found");
	m_add->setObjectName("addStorey");
	m_remove->setObjectName("removeStorey");
	m_reset->setObjectName("resetStoreys");
	m_reset->setToolTip("Forget the corrections: the run finds the storeys by itself");

	auto* buttons = new QVBoxLayout;
	buttons->addWidget(m_add);
	buttons->addWidget(m_remove);
	buttons->addWidget(m_reset);
	buttons->addStretch();
	auto* bottom = new QHBoxLayout;
	bottom->addWidget(m_table, 1);
	bottom->addLayout(buttons);
	auto* column = new QVBoxLayout(this);
	column->addWidget(m_hint);
	column->addWidget(m_progress);
	column->addWidget(m_view, 1);
	column->addLayout(bottom);

	connect(m_view, &S2BLevelView::dragged, this, [this]
	        { setStoreys(m_view->storeys(), true); });
	connect(m_table, &QTableWidget::cellChanged, this, &S2BLevelPage::readTable);
	connect(m_table, &QTableWidget::itemSelectionChanged, this, [this]
	        { m_remove->setEnabled(m_table->rowCount() > 1); });
	connect(m_add, &QPushButton::clicked, this, &S2BLevelPage::addStorey);
	connect(m_remove, &QPushButton::clicked, this, &S2BLevelPage::removeStorey);
	connect(m_reset, &QPushButton::clicked, this, [this]
	        { setStoreys(m_found, false); });
	connect(&m_watcher, &QFutureWatcher<void>::finished, this, &S2BLevelPage::finish);
	setStoreys({}, false);
	m_progress->hide();
}

S2BLevelPage::~S2BLevelPage()
{
	stop();
}

void S2BLevelPage::stop()
{
	if (!m_work)
		return;
	m_work->stop.request_stop();
	m_watcher.disconnect(this);
	m_watcher.waitForFinished();
	m_work.reset();
}

std::vector<s2b::StoreyHeights> S2BLevelPage::given() const
{
	return m_areCorrected ? m_view->storeys() : std::vector<s2b::StoreyHeights>{};
}

void S2BLevelPage::showEvent(QShowEvent* event)
{
	QWidget::showEvent(event);
	refresh();
}

void S2BLevelPage::refresh()
{
	if (!isVisible() || keyOf(m_request()) == m_lastKey)
		return;
	start();
}

void S2BLevelPage::start()
{
	stop();
	const Request request = m_request();
	m_lastKey             = keyOf(request);
	m_work                = std::make_shared<Work>();
	m_progress->show();
	say("Looking for the storeys ...");
	connect(&m_watcher, &QFutureWatcher<void>::finished, this, &S2BLevelPage::finish, Qt::UniqueConnection);
	m_watcher.setFuture(QtConcurrent::run([work = m_work, request, clouds = m_clouds]
	                                      {
		                                      try
		                                      {
			                                      s2b::Context context;
			                                      context.cancel = work->stop.get_token();
			                                      const s2b::Input input = s2b::makeInput(clouds, request.labels, {}, context);
			                                      work->survey           = s2b::surveyLevels(input.view, request.options, context);
			                                      work->isDone           = true;
		                                      }
		                                      catch (const s2b::Cancelled&)
		                                      {
		                                      }
		                                      catch (const std::exception& e)
		                                      {
			                                      work->failure = QString::fromUtf8(e.what());
		                                      } }));
}

void S2BLevelPage::finish()
{
	m_progress->hide();
	if (!m_work)
		return;
	const std::shared_ptr<Work> work = std::exchange(m_work, nullptr);
	if (!work->isDone)
	{
		m_lastKey.clear();
		say(QString("<span style='color:#b00020'>%1</span>").arg(work->failure.toHtmlEscaped()));
		return;
	}
	m_found = work->survey.storeys;
	m_view->setProfile(work->survey.profile);
	setStoreys(m_areCorrected ? m_view->storeys() : m_found, m_areCorrected);
}

void S2BLevelPage::setStoreys(const std::vector<s2b::StoreyHeights>& storeys, bool areCorrected)
{
	m_areCorrected = areCorrected;
	if (&storeys != &m_view->storeys())
		m_view->setStoreys(storeys);
	fillTable();
	m_remove->setEnabled(storeys.size() > 1);
	m_add->setEnabled(!m_lastKey.isEmpty());
	m_reset->setEnabled(areCorrected);
	if (areCorrected)
		say("<b>The run takes these heights</b> as its storeys.");
	else if (storeys.empty())
		say(m_lastKey.isEmpty() ? QString() : QString("No storey was found: is the cloud's Z axis up? Add the storeys by hand."));
	else
		say(QString("%1 found in the horizontal surfaces of the cloud. Drag a line where it is wrong: the run then takes your heights.").arg(storeys.size() == 1 ? QString("One storey") : QString("%1 storeys").arg(storeys.size())));
}

void S2BLevelPage::fillTable()
{
	const QSignalBlocker                   quiet(m_table);
	const std::vector<s2b::StoreyHeights>& storeys = m_view->storeys();
	m_table->setRowCount(static_cast<int>(storeys.size()));
	for (int row = 0; row < m_table->rowCount(); ++row)
	{
		const s2b::StoreyHeights& storey = storeys[static_cast<std::size_t>(row)];
		m_table->setVerticalHeaderItem(row, new QTableWidgetItem(QString("Level %1").arg(row)));
		int column = 0;
		for (const double height_m : {storey.floor_m, storey.ceiling_m})
		{
			auto* item = new QTableWidgetItem(heightText(height_m, 3));
			item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
			m_table->setItem(row, column++, item);
		}
	}
}

// What was typed counts when it leaves the storeys in order; otherwise the old value comes back.
void S2BLevelPage::readTable(int row, int column)
{
	std::vector<s2b::StoreyHeights> storeys           = m_view->storeys();
	bool                            isNumber          = false;
	const double                    typed             = m_table->item(row, column)->text().replace(',', '.').toDouble(&isNumber);
	s2b::StoreyHeights&             storey            = storeys.at(static_cast<std::size_t>(row));
	(column == 0 ? storey.floor_m : storey.ceiling_m) = typed;
	double last                                       = -1.0e9;
	bool   isInOrder                                  = isNumber;
	for (const s2b::StoreyHeights& each : storeys)
	{
		isInOrder = isInOrder && each.floor_m >= last && each.ceiling_m > each.floor_m;
		last      = each.ceiling_m;
	}
	if (isInOrder)
		setStoreys(storeys, true);
	else
		fillTable();
}

void S2BLevelPage::addStorey()
{
	std::vector<s2b::StoreyHeights> storeys = m_view->storeys();
	const double                    floor_m = storeys.empty() ? 0.0 : storeys.back().ceiling_m + kNewSlab_m;
	storeys.push_back({floor_m, floor_m + kNewRoom_m, false});
	setStoreys(storeys, true);
}

void S2BLevelPage::removeStorey()
{
	std::vector<s2b::StoreyHeights> storeys = m_view->storeys();
	if (storeys.size() < 2)
		return;
	const int row = m_table->currentRow() < 0 ? static_cast<int>(storeys.size()) - 1 : m_table->currentRow();
	storeys.erase(storeys.begin() + row);
	setStoreys(storeys, true);
}

void S2BLevelPage::say(const QString& text)
{
	m_hint->setText(text);
}
