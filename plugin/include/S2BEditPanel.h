// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "S2BPicker.h"
#include "core/corrections/model.h"

#include <QDockWidget>
#include <ccHObject.h>
#include <functional>
#include <set>
#include <vector>

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class S2BElementForm;
class ccMainAppInterface;

//! Edit element: the dimensions and the class of what is selected, merging and splitting walls, walls and levels by
//! picked points, and back to the reconstructed state
class S2BEditPanel : public QDockWidget
{
	Q_OBJECT

  public:
	explicit S2BEditPanel(ccMainAppInterface& app);

	//! Shows what is selected
	void setSelection(const ccHObject::Container& selection);

  private:
	using Change = std::function<s2b::Model(const s2b::Model&)>;

	QPushButton* addButton(const char* name, const QString& text, const QString& toolTip, void (S2BEditPanel::*onClick)());
	void         show(const s2b::Model& model);
	void         showNothing(const QString& why);
	void         say(const QString& text, bool isWrong = false);
	bool         edit(const Change& change, const QString& done, const std::set<s2b::ElementId>& unmoved = {});
	void         selectElement(s2b::ElementId id);

	void apply();
	void reset();
	void merge();
	void split();
	void addWall();
	void addLevel();
	void pickForWall(const CCVector3d& world);
	void finishWall();
	void endPicking();

	ccMainAppInterface&         m_app;
	S2BPicker                   m_picker;
	ccHObject*                  m_root = nullptr; //!< the model that the selection belongs to
	std::vector<s2b::ElementId> m_ids;            //!< of what is selected
	std::vector<CCVector3d>     m_picked;

	S2BElementForm* m_form         = nullptr;
	QPushButton*    m_apply        = nullptr;
	QPushButton*    m_reset        = nullptr;
	QPushButton*    m_merge        = nullptr;
	QPushButton*    m_split        = nullptr;
	QPushButton*    m_addWall      = nullptr;
	QPushButton*    m_addLevel     = nullptr;
	QPushButton*    m_cancel       = nullptr;
	QDoubleSpinBox* m_newThickness = nullptr;
	QLabel*         m_state        = nullptr;
	QLabel*         m_message      = nullptr;
};
