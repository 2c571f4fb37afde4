// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BModel.h"

#include "S2BBuildingText.h"
#include "S2BEntities.h"
#include "core/corrections/corrections.h"

#include <algorithm>
#include <ccPointCloud.h>

namespace s2b
{
	namespace
	{
		QVariantMap wrapped(const Building& building)
		{
			return {{"text", buildingText(building)}}; // a map keeps the Properties panel short
		}
		Building unwrapped(const ccHObject& root, const char* key)
		{
			return parseBuilding(root.getMetaData(key).toMap().value("text").toString());
		}

		QVariantList corner(const ccPointCloud& cloud, unsigned index)
		{
			const CCVector3d p = cloud.toGlobal3d(*cloud.getPoint(index));
			return {p.x, p.y, p.z};
		}

		// Unique ids change when a file is opened: the points themselves tell.
		QVariantMap fingerprint(const ccPointCloud& cloud)
		{
			QVariantMap map{{"size", cloud.size()}};
			if (cloud.size())
			{
				map["first"]  = corner(cloud, 0);
				map["middle"] = corner(cloud, cloud.size() / 2);
				map["last"]   = corner(cloud, cloud.size() - 1);
			}
			return map;
		}

		bool isCloud(const ccPointCloud& cloud, const QVariantMap& known)
		{
			constexpr double  kSame_m = 0.01; // a georeferenced cloud that was opened with another shift is rounded otherwise
			const QVariantMap own     = fingerprint(cloud);
			if (own["size"].toUInt() != known["size"].toUInt())
				return false;
			for (const char* key : {"first", "middle", "last"})
			{
				const QVariantList a = own[key].toList();
				const QVariantList b = known[key].toList();
				for (int i = 0; i < 3 && i < a.size(); ++i)
				{
					if (i >= b.size() || std::abs(a[i].toDouble() - b[i].toDouble()) > kSame_m)
						return false;
				}
			}
			return true;
		}

		std::vector<ccPointCloud*> allClouds(const ccHObject& dbRoot)
		{
			ccHObject::Container all;
			dbRoot.filterChildren(all, true, CC_TYPES::POINT_CLOUD, true);
			std::vector<ccPointCloud*> clouds;
			for (ccHObject* entity : all)
				clouds.push_back(static_cast<ccPointCloud*>(entity));
			return clouds;
		}
	} // namespace

	void storeModel(ccHObject& root, const Model& model)
	{
		root.setMetaData(QString(kBuildingKey), wrapped(model.found));
		root.removeMetaData(kCorrectedKey);
		if (buildingText(model.found) != buildingText(model.corrected))
			root.setMetaData(QString(kCorrectedKey), wrapped(model.corrected));
		QVariantMap names;
		for (const auto& [id, name] : model.names)
			names[QString::number(id.value)] = QString::fromStdString(name);
		root.setMetaData(QString(kNamesKey), names);
	}

	Model storedModel(const ccHObject& root)
	{
		Model model;
		model.found           = unwrapped(root, kBuildingKey);
		model.corrected       = root.hasMetaData(kCorrectedKey) ? unwrapped(root, kCorrectedKey) : model.found;
		const QVariantMap all = root.getMetaData(kNamesKey).toMap();
		for (auto name = all.begin(); name != all.end(); ++name)
			model.names[ElementId{name.key().toUInt()}] = name.value().toString().toStdString();
		return model;
	}

	std::unique_ptr<ccPointCloud> referenceOf(const ccHObject& root)
	{
		auto               reference = std::make_unique<ccPointCloud>("reference");
		const QVariantList values    = root.getMetaData(kShiftKey).toList();
		if (values.size() == 4)
		{
			reference->setGlobalShift(values[0].toDouble(), values[1].toDouble(), values[2].toDouble());
			reference->setGlobalScale(values[3].toDouble());
			return reference;
		}
		ccHObject::Container clouds; // a model of an earlier version
		root.filterChildren(clouds, true, CC_TYPES::POINT_CLOUD, true);
		if (!clouds.empty())
			reference->copyGlobalShiftAndScale(*static_cast<ccPointCloud*>(clouds.front()));
		return reference;
	}

	void rememberClouds(ccHObject& root, const std::vector<ccPointCloud*>& clouds)
	{
		QVariantList list;
		for (const ccPointCloud* cloud : clouds)
			list << QVariant(fingerprint(*cloud));
		root.setMetaData(QString(kCloudsKey), list);
	}

	std::vector<ccPointCloud*> cloudsOfModel(const ccHObject& dbRoot, const ccHObject& root)
	{
		std::vector<ccPointCloud*>       found;
		const std::vector<ccPointCloud*> all = allClouds(dbRoot);
		for (const QVariant& known : root.getMetaData(kCloudsKey).toList())
		{
			const auto cloud = std::find_if(all.begin(), all.end(), [&](const ccPointCloud* c)
			                                { return isCloud(*c, known.toMap()); });
			if (cloud == all.end())
				return {};
			found.push_back(*cloud);
		}
		return found;
	}

	void rememberLevels(ccHObject& root, const std::vector<StoreyHeights>& levels)
	{
		QVariantList list;
		for (const StoreyHeights& level : levels)
			list << QVariant(QVariantList{level.floor_m, level.ceiling_m, level.ceilingSeen});
		root.removeMetaData(kGivenKey);
		if (!list.isEmpty())
			root.setMetaData(QString(kGivenKey), list);
	}

	std::vector<StoreyHeights> givenLevelsOf(const ccHObject& root)
	{
		std::vector<StoreyHeights> levels;
		for (const QVariant& level : root.getMetaData(kGivenKey).toList())
		{
			const QVariantList values = level.toList();
			if (values.size() == 3)
				levels.push_back({values[0].toDouble(), values[1].toDouble(), values[2].toBool()});
		}
		return levels;
	}

	ccHObject* modelOfClouds(const ccHObject& dbRoot, const std::vector<ccPointCloud*>& clouds)
	{
		ccHObject::Container groups;
		dbRoot.filterChildren(groups, true);
		ccHObject* newest = nullptr;
		for (ccHObject* group : groups)
		{
			const QVariantList known = group->getMetaData(kCloudsKey).toList();
			const bool         isIts = known.size() == static_cast<int>(clouds.size()) && std::all_of(clouds.begin(), clouds.end(), [&](const ccPointCloud* c)
                                                                                              { return std::any_of(known.begin(), known.end(), [&](const QVariant& k)
                                                                                                                   { return isCloud(*c, k.toMap()); }); });
			if (group->hasMetaData(kBuildingKey) && isIts && (!newest || group->getUniqueID() > newest->getUniqueID()))
				newest = group;
		}
		return newest;
	}

	ElementId storeyOfEntity(const ccHObject& entity)
	{
		for (const ccHObject* e = &entity; e; e = e->getParent())
		{
			if (e->getParent() && e->getParent()->hasMetaData(kBuildingKey))
				return {e->getMetaData(kIdKey).toUInt()};
		}
		return {};
	}

	std::map<ElementId, ccHObject*> elementEntities(const ccHObject& root)
	{
		std::map<ElementId, ccHObject*> entities;
		ccHObject::Container            all;
		root.filterChildren(all, true);
		for (ccHObject* entity : all)
		{
			if (entity->hasMetaData(kIdKey))
				entities.emplace(ElementId{entity->getMetaData(kIdKey).toUInt()}, entity); // of copies the first
		}
		return entities;
	}
} // namespace s2b
