// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BTreeUpdate.h"

#include "S2BActions.h"
#include "S2BEntities.h"
#include "S2BFindings.h"
#include "S2BModel.h"
#include "S2BSummary.h"
#include "core/corrections/same.h"

#include <algorithm>
#include <ccGenericMesh.h>
#include <ccMainAppInterface.h>
#include <ccPointCloud.h>
#include <map>

namespace s2b
{
	namespace
	{
		constexpr char kTranslucentKey[] = "S2B.Translucent";

		// What an entity stands for; empty for groups and for what is not ours.
		QString keyOf(const ccHObject& entity)
		{
			for (const char* key : {kLevelKey, kAxisKey})
			{
				if (entity.hasMetaData(key))
					return key + entity.getMetaData(key).toString();
			}
			return entity.hasMetaData(kIdKey) && entity.hasMetaData(kShapeKey) ? entity.getMetaData(kIdKey).toString() : QString();
		}

		std::map<QString, ccHObject*> entitiesOf(const ccHObject& root)
		{
			std::map<QString, ccHObject*> entities;
			ccHObject::Container          all;
			root.filterChildren(all, true);
			for (ccHObject* entity : all)
			{
				const QString key = keyOf(*entity);
				if (!key.isEmpty())
					entities.emplace(key, entity);
			}
			return entities;
		}

		ElementId ownId(const ccHObject& entity)
		{
			for (const char* key : {kIdKey, kLevelKey})
			{
				if (entity.hasMetaData(key))
					return {entity.getMetaData(key).toUInt()};
			}
			return {};
		}

		ccHObject* childNamed(ccHObject& parent, const QString& name)
		{
			for (unsigned i = 0; i < parent.getChildrenNumber(); ++i)
			{
				if (parent.getChild(i)->getName() == name)
					return parent.getChild(i);
			}
			return nullptr;
		}

		ccHObject* storeyGroup(ccHObject& root, const ccHObject& like)
		{
			for (unsigned i = 0; i < root.getChildrenNumber(); ++i)
			{
				if (root.getChild(i)->hasMetaData(kIdKey) && root.getChild(i)->getMetaData(kIdKey) == like.getMetaData(kIdKey))
					return root.getChild(i);
			}
			return nullptr;
		}

		void addBelow(ccMainAppInterface& app, ccHObject& parent, ccHObject* entity)
		{
			parent.addChild(entity);
			entity->setDisplay_recursive(parent.getDisplay());
			app.addToDB(entity, false, false, false, false);
		}

		// The group of `tree` in which an entity belongs that was made in the group `from`.
		ccHObject& groupFor(ccMainAppInterface& app, ccHObject& root, const ccHObject& from)
		{
			const bool       isStorey = from.hasMetaData(kIdKey);
			const ccHObject& storey   = isStorey ? from : *from.getParent();
			ccHObject*       group    = storeyGroup(root, storey);
			if (!group)
			{
				group = new ccHObject(storey.getName());
				group->setMetaData(storey.metaData());
				group->setDisplay(root.getDisplay());
				addBelow(app, root, group);
			}
			if (isStorey)
				return *group;
			ccHObject* classes = childNamed(*group, from.getName());
			if (!classes)
			{
				classes = new ccHObject(from.getName());
				classes->setEnabled(from.isEnabled());
				classes->setDisplay(root.getDisplay());
				addBelow(app, *group, classes);
			}
			return *classes;
		}

		void removeEmptyGroups(ccMainAppInterface& app, ccHObject& root, const ccHObject& fresh)
		{
			for (unsigned i = root.getChildrenNumber(); i-- > 0;)
			{
				ccHObject* storey = root.getChild(i);
				if (!storey->hasMetaData(kIdKey))
					continue;
				const ccHObject* kept = storeyGroup(const_cast<ccHObject&>(fresh), *storey);
				for (unsigned k = storey->getChildrenNumber(); k-- > 0;)
				{
					ccHObject* group = storey->getChild(k);
					if (group->getClassID() == CC_TYPES::HIERARCHY_OBJECT && !group->getChildrenNumber())
						app.removeFromDB(group);
				}
				if (!kept)
				{
					app.removeFromDB(storey);
					continue;
				}
				storey->setName(kept->getName());
				storey->setMetaData(kept->metaData(), true);
			}
		}

		// Everything of ours that `root` shows, by what it stands for.
		void replaceEntities(ccMainAppInterface& app, ccHObject& root, ccHObject& fresh, const std::set<ElementId>& anew)
		{
			std::map<QString, ccHObject*> now    = entitiesOf(root);
			const auto                    wanted = entitiesOf(fresh);
			ccHObject::Container          levels; // copies of level planes became levels of their own
			root.filterChildren(levels, true, CC_TYPES::PLANE);
			for (ccHObject* plane : levels)
			{
				const auto known = now.find(keyOf(*plane));
				if (known == now.end() || known->second != plane)
					app.removeFromDB(plane);
			}
			for (const auto& [key, entity] : std::map<QString, ccHObject*>(now))
			{
				const auto target = wanted.find(key);
				if (target == wanted.end())
				{
					app.removeFromDB(entity);
					now.erase(key);
				}
			}
			ccHObject::Container ordered; // as a new tree would show them
			fresh.filterChildren(ordered, true);
			for (ccHObject* entity : ordered)
			{
				const QString key = keyOf(*entity);
				if (key.isEmpty())
					continue;
				const auto known = now.find(key);
				const bool isUp  = known != now.end() && !anew.count(ownId(*entity)) && known->second->getMetaData(kShapeKey) == entity->getMetaData(kShapeKey);
				if (isUp)
				{
					known->second->setName(entity->getName());
					continue;
				}
				ccHObject& group = groupFor(app, root, *entity->getParent());
				if (known != now.end())
				{
					entity->setEnabled(known->second->isEnabled());
					entity->setVisible(known->second->isVisible());
					app.removeFromDB(known->second);
				}
				entity->getParent()->detachChild(entity);
				addBelow(app, group, entity);
			}
		}

		void sayNewDiagnostics(ccMainAppInterface& app, const Building& before, const Building& after)
		{
			for (const Diagnostic& d : after.diagnostics)
			{
				if (std::none_of(before.diagnostics.begin(), before.diagnostics.end(), [&](const Diagnostic& k)
				                 { return isSame(d, k); }))
					say(app, diagnosticText(after, d), d.severity != Severity::Info);
			}
		}
	} // namespace

	void updateTree(ccMainAppInterface& app, ccHObject& root, const Model& model, const std::set<ElementId>& anew)
	{
		Eigen::AlignedBox2d plan;
		const QVariantList  known = root.getMetaData(kPlanKey).toList();
		if (known.size() == 4)
			plan = Eigen::AlignedBox2d(Eigen::Vector2d(known[0].toDouble(), known[1].toDouble()), Eigen::Vector2d(known[2].toDouble(), known[3].toDouble()));
		const Building                   before    = storedModel(root).corrected;
		const auto                       reference = referenceOf(root);
		const std::unique_ptr<ccHObject> fresh     = makeTree(model, *reference, root.getName(), plan);
		replaceEntities(app, root, *fresh, anew);
		removeEmptyGroups(app, root, *fresh);
		for (const char* key : {kShiftKey, kPlanKey, kBodilessKey})
			root.setMetaData(QString(key), fresh->getMetaData(key));
		renewFindings(app, root, before, model.corrected, *reference);
		storeModel(root, model);
		sayNewDiagnostics(app, before, model.corrected);
		setTranslucent(root, isTranslucent(root));
		root.prepareDisplayForRefresh_recursive();
		app.refreshAll();
		app.updateUI();
	}

	QString editModel(ccMainAppInterface& app, ccHObject& root, const std::function<Model(const Model&)>& change, const std::set<ElementId>& unmoved)
	{
		try
		{
			const ModelState    state = readModel(root, unmoved);
			const Model         model = change(state.model);
			std::set<ElementId> anew  = state.moved;
			anew.insert(unmoved.begin(), unmoved.end());
			updateTree(app, root, model, anew);
			return {};
		}
		catch (const std::exception& e)
		{
			say(app, QString::fromUtf8(e.what()), true);
			return QString::fromUtf8(e.what());
		}
	}

	bool isTranslucent(const ccHObject& root)
	{
		return root.getMetaData(kTranslucentKey).toBool();
	}

	void setTranslucent(ccHObject& root, bool isTranslucent)
	{
		root.setMetaData(QString(kTranslucentKey), isTranslucent);
		ccHObject::Container meshes;
		root.filterChildren(meshes, true, CC_TYPES::MESH);
		for (ccHObject* entity : meshes)
		{
			if (entity->hasMetaData(kIdKey))
				static_cast<ccGenericMesh*>(entity)->enableStippling(isTranslucent);
		}
		root.prepareDisplayForRefresh_recursive();
	}
} // namespace s2b
