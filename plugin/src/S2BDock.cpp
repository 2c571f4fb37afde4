// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BDock.h"

#include "S2BView.h"

#include <QAbstractItemModel>
#include <QCloseEvent>
#include <QMainWindow>
#include <QTimer>
#include <ccHObject.h>
#include <ccMainAppInterface.h>

S2BDock::S2BDock(ccMainAppInterface& app, const QString& name, const QString& title)
    : QDockWidget(title, app.getMainWindow())
    , m_app(app)
    , m_delay(new QTimer(this))
{
	setObjectName(name);
	QMainWindow* window = app.getMainWindow();
	window->addDockWidget(Qt::BottomDockWidgetArea, this);
	// In the console's place: the 3D view keeps its size.
	if (auto* console = window->findChild<QDockWidget*>("DockableConsole"))
		window->tabifyDockWidget(console, this);
	hide();

	// Entities are added and removed one by one: the list is filled once, when they are through.
	m_delay->setSingleShot(true);
	m_delay->setInterval(0);
	connect(m_delay, &QTimer::timeout, this, [this]
	        {
		        if (entitiesNow() != m_entities)
			        fillAnew(); });
	if (QAbstractItemModel* model = s2b::treeModel(app))
	{
		const auto later = [this]
		{ m_delay->start(); };
		connect(model, &QAbstractItemModel::rowsRemoved, this, later);
		connect(model, &QAbstractItemModel::rowsInserted, this, later);
		connect(model, &QAbstractItemModel::modelReset, this, later);
	}
}

void S2BDock::setSubject(const ccHObject* group)
{
	const unsigned id = group ? group->getUniqueID() : 0;
	if (id == m_subject)
		return;
	m_subject = id;
	fillAnew();
}

ccHObject* S2BDock::subject() const
{
	return m_subject ? s2b::findEntity(m_app, m_subject) : nullptr;
}

std::vector<unsigned> S2BDock::entitiesNow() const
{
	ccHObject::Container all;
	if (const ccHObject* group = subject())
		group->filterChildren(all, true);
	std::vector<unsigned> ids;
	for (const ccHObject* entity : all)
		ids.push_back(entity->getUniqueID());
	return ids;
}

void S2BDock::fillAnew()
{
	m_entities = entitiesNow();
	fill();
}

void S2BDock::present()
{
	m_wasClosed = false;
	// It glides to its place from where it was last, over the lists above if that is the window's corner.
	QMainWindow* window  = m_app.getMainWindow();
	const auto*  console = window->findChild<QDockWidget*>("DockableConsole");
	if (console && !isVisible() && !isFloating())
		setGeometry(console->geometry());
	show();
	lower(); // a new dock is the uppermost widget already, and raising it would not bring its tab to the front
	raise();
	QTimer::singleShot(0, window, qOverload<>(&QWidget::update));
}

void S2BDock::offer()
{
	if (!m_wasClosed)
		present();
}

void S2BDock::closeEvent(QCloseEvent* event)
{
	m_wasClosed = true;
	QDockWidget::closeEvent(event);
}
