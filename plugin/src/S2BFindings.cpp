// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BFindings.h"

#include "S2BView.h"
#include "core/corrections/corrections.h"

#include <algorithm>
#include <cc2DLabel.h>
#include <ccMainAppInterface.h>
#include <ccPointCloud.h>
#include <map>
#include <set>

namespace s2b
{
	namespace
	{
		constexpr double  kAround_m        = 2.5; // shown around a finding
		constexpr float   kMarkerScale     = 0.4F;
		constexpr float   kLabelX          = 0.06F; // of the view, where an open label's text is
		constexpr float   kLabelY          = 0.12F;
		const char* const kSeverityNames[] = {"Info", "Warning", "Error"};

		QVariantMap metaData(const Building& building, const Diagnostic& diagnostic)
		{
			QVariantMap map;
			map[kFindingKey] = QString::fromStdString(diagnostic.code);
			map["Severity"]  = kSeverityNames[static_cast<int>(diagnostic.severity)];
			map["Stage"]     = QString::fromStdString(diagnostic.stage);
			map["Text"]      = QString::fromStdString(diagnostic.text);
			if (const QString element = QString::fromStdString(nameOf(building, diagnostic.element)); !element.isEmpty())
				map["Element"] = element;
			return map;
		}

		// What a label says, and of what; its place comes with the element.
		QString identity(const QVariantMap& map)
		{
			return QStringList{map[kFindingKey].toString(), map["Stage"].toString(), map["Element"].toString(), map["Text"].toString()}.join('|');
		}

		std::vector<cc2DLabel*> labelsOf(const ccHObject& tree)
		{
			ccHObject::Container all;
			tree.filterChildren(all, true, CC_TYPES::LABEL_2D, true);
			std::vector<cc2DLabel*> labels;
			for (ccHObject* entity : all)
			{
				if (entity->hasMetaData(kFindingKey))
					labels.push_back(static_cast<cc2DLabel*>(entity));
			}
			return labels;
		}

		void nameGroup(ccHObject& group, std::size_t count)
		{
			group.setName(QString("Findings (%1)").arg(count));
			group.setMetaData(QString(kFindingsKey), static_cast<unsigned>(count));
		}

		ccHObject* groupOf(const ccHObject& model)
		{
			for (unsigned i = 0; i < model.getChildrenNumber(); ++i)
			{
				if (model.getChild(i)->hasMetaData(kFindingsKey))
					return model.getChild(i);
			}
			return nullptr;
		}

		bool isSame(const std::vector<cc2DLabel*>& a, const std::vector<cc2DLabel*>& b)
		{
			return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const cc2DLabel* x, const cc2DLabel* y)
			                  { return x->metaData() == y->metaData() && x->size() && y->size() && (x->getPickedPoint(0).getPointPosition() - y->getPickedPoint(0).getPointPosition()).norm2() == 0; });
		}
	} // namespace

	QString findingTitle(const QString& code)
	{
		QString title;
		for (const QChar c : code)
		{
			if (c.isUpper() && !title.isEmpty())
				title += ' ';
			title += title.isEmpty() ? c : c.toLower();
		}
		return title;
	}

	Eigen::Vector3d placeOf(const Building& building, const Diagnostic& diagnostic)
	{
		Eigen::Vector3d place = diagnostic.location;
		if (!place.head<2>().isZero())
			return place;
		Eigen::AlignedBox2d plan;
		for (const Wall& wall : building.walls)
			plan.extend(wall.start).extend(wall.end);
		for (const Column& column : building.columns)
			plan.extend(column.center);
		if (!plan.isEmpty())
			place.head<2>() = plan.center();
		return place;
	}

	std::unique_ptr<ccHObject> makeFindings(const Building& building, const ccShiftedObject& reference)
	{
		std::vector<const Diagnostic*> sorted;
		for (const Diagnostic& diagnostic : building.diagnostics)
			sorted.push_back(&diagnostic);
		if (sorted.empty())
			return {};
		std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic* a, const Diagnostic* b)
		                 { return a->severity > b->severity; });

		// A label points at a point of a cloud: theirs is one of their own.
		auto places = std::make_unique<ccPointCloud>("places");
		if (!places->reserve(static_cast<unsigned>(sorted.size())))
			throw std::bad_alloc();
		for (const Diagnostic* diagnostic : sorted)
		{
			const Eigen::Vector3d world = building.frame.toWorld(placeOf(building, *diagnostic));
			places->addPoint(reference.toLocal3d(CCVector3d(world.x(), world.y(), world.z())).toPC());
		}
		places->copyGlobalShiftAndScale(reference);
		places->setVisible(false); // the labels' own marks are enough
		auto group = std::make_unique<ccHObject>();
		nameGroup(*group, sorted.size());
		for (std::size_t i = 0; i < sorted.size(); ++i)
		{
			auto*             label = new cc2DLabel; // the cloud's, as its child
			const QVariantMap map   = metaData(building, *sorted[i]);
			const QString     title = findingTitle(map[kFindingKey].toString());
			label->addPickedPoint(places.get(), static_cast<unsigned>(i));
			label->setName(map.contains("Element") ? QString("%1: %2").arg(title, map["Element"].toString()) : title);
			label->setMetaData(map);
			label->setDisplayedIn2D(false);
			label->displayPointLegend(false);
			label->setRelativeMarkerScale(kMarkerScale);
			label->setPosition(kLabelX, kLabelY);
			label->setCollapsed(true);
			label->setVisible(true);
			label->setEnabled(sorted[i]->severity != Severity::Info);
			places->addChild(label);
		}
		group->addChild(places.release());
		return group;
	}

	void renewFindings(ccMainAppInterface& app, ccHObject& model, const Building& before, const Building& after, const ccShiftedObject& reference)
	{
		ccHObject*                    known = groupOf(model);
		const std::vector<cc2DLabel*> shown = known ? labelsOf(*known) : std::vector<cc2DLabel*>();
		std::map<QString, bool>       isEnabled;
		for (const cc2DLabel* label : shown)
			isEnabled[identity(label->metaData())] = label->isEnabled();
		std::set<QString> dismissed;
		for (const Diagnostic& diagnostic : before.diagnostics)
		{
			if (const QString id = identity(metaData(before, diagnostic)); !isEnabled.count(id))
				dismissed.insert(id);
		}
		Building wanted = after;
		std::erase_if(wanted.diagnostics, [&](const Diagnostic& diagnostic)
		              { return dismissed.count(identity(metaData(after, diagnostic))) > 0; });

		std::unique_ptr<ccHObject>    fresh  = makeFindings(wanted, reference);
		const std::vector<cc2DLabel*> labels = fresh ? labelsOf(*fresh) : std::vector<cc2DLabel*>();
		if (isSame(shown, labels))
			return;
		for (cc2DLabel* label : labels)
		{
			if (const auto now = isEnabled.find(identity(label->metaData())); now != isEnabled.end())
				label->setEnabled(now->second);
		}
		if (known && fresh)
			fresh->setEnabled(known->isEnabled());
		if (known)
			app.removeFromDB(known);
		if (!fresh)
			return;
		ccHObject* group = fresh.release(); // the model's
		model.addChild(group);
		group->setDisplay_recursive(model.getDisplay());
		app.addToDB(group, false, false, false, false);
	}

	bool recountFindings(ccHObject& tree)
	{
		bool                 isAnother = false;
		ccHObject::Container all;
		tree.filterChildren(all, true);
		for (ccHObject* entity : all)
		{
			if (!entity->hasMetaData(kFindingsKey))
				continue;
			const std::size_t count = labelsOf(*entity).size();
			if (entity->getMetaData(kFindingsKey).toUInt() == count)
				continue;
			nameGroup(*entity, count);
			isAnother = true;
		}
		return isAnother;
	}

	std::vector<Finding> findingsIn(const ccHObject& tree)
	{
		std::vector<Finding> findings;
		for (const cc2DLabel* label : labelsOf(tree))
		{
			if (label->size() == 0)
				continue;
			Finding       finding;
			const QString severity = label->getMetaData("Severity").toString();
			finding.severity       = severity == kSeverityNames[2] ? Severity::Error : severity == kSeverityNames[1] ? Severity::Warning
			                                                                                                         : Severity::Info;
			finding.id             = label->getUniqueID();
			finding.title          = findingTitle(label->getMetaData(kFindingKey).toString());
			finding.stage          = label->getMetaData("Stage").toString();
			finding.text           = label->getMetaData("Text").toString();
			finding.element        = label->getMetaData("Element").toString();
			finding.place          = label->getPickedPoint(0).getPointPosition();
			findings.push_back(finding);
		}
		return findings;
	}

	ccHObject* findingOf(const ccHObject::Container& selection)
	{
		const bool isOne = selection.size() == 1 && selection.front() && selection.front()->isA(CC_TYPES::LABEL_2D);
		return isOne && selection.front()->hasMetaData(kFindingKey) ? selection.front() : nullptr;
	}

	void showFinding(ccMainAppInterface& app, ccHObject& entity)
	{
		auto& label = static_cast<cc2DLabel&>(entity);
		if (label.size() == 0)
			return;
		for (cc2DLabel* other : labelsOf(*app.dbRootObject()))
			other->displayPointLegend(false);
		label.setEnabled(true);
		label.displayPointLegend(true);
		const auto* places = static_cast<const ccShiftedObject*>(label.getPickedPoint(0).cloudOrVertices());
		lookAt(app, label.getPickedPoint(0).getPointPosition(), kAround_m * places->getGlobalScale());
	}
} // namespace s2b
