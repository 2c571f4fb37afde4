// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QPointer>
#include <vector>

class QTimer;
class ccHObject;
class ccMainAppInterface;

//! A list beside the console that tells about one group of the DB tree, and goes with it
/** Belongs to CloudCompare's window. Entities are held by their ids: they may be deleted at any time. **/
class S2BDock : public QDockWidget
{
	Q_OBJECT

  public:
	S2BDock(ccMainAppInterface& app, const QString& name, const QString& title);

	//! Tells about that group from now on
	void setSubject(const ccHObject* group);

	//! The group, null when it is gone
	ccHObject* subject() const;

	//! Brings the list to the front
	void present();

	//! As present(), but not when the user closed it before
	void offer();

	//! The dock of a window, made on the first call
	template <typename Dock>
	static Dock* of(ccMainAppInterface& app)
	{
		static QPointer<Dock> dock;
		if (!dock)
			dock = new Dock(app); // the window's
		return dock;
	}

  protected:
	//! Shows what the subject says now
	virtual void fill() = 0;

	void closeEvent(QCloseEvent* event) override;

	ccMainAppInterface& m_app;

  private:
	std::vector<unsigned> entitiesNow() const;
	void                  fillAnew();

	unsigned              m_subject   = 0;
	bool                  m_wasClosed = false;
	std::vector<unsigned> m_entities; //!< unique ids of the subject's, when the list was filled
	QTimer*               m_delay = nullptr;
};
