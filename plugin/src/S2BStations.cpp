// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BStations.h"

#include "core/base/error.h"
#include "core/cloud/station_file.h"

#include <Eigen/Geometry>
#include <QFile>
#include <algorithm>
#include <ccGBLSensor.h>
#include <ccPointCloud.h>
#include <ccScalarField.h>
#include <limits>

namespace s2b
{
	namespace
	{
		constexpr double      kFarthest_m = 500.0;             // no scanner measures a building from further away
		constexpr const char* kIdField    = "Point Source ID"; // readers may write it with underscores

		using Bounds = Eigen::AlignedBox3d;

		Eigen::Vector3d inView(const ccPointCloud& cloud, const CCVector3& point, const Input& input)
		{
			const CCVector3d p = cloud.toGlobal3d(point);
			return Eigen::Vector3d(p.x, p.y, p.z) - input.view.origin;
		}

		Bounds boundsOf(const std::vector<const ccPointCloud*>& clouds, const Input& input)
		{
			Bounds bounds;
			for (const ccPointCloud* cloud : clouds)
			{
				CCVector3 low, high;
				const_cast<ccPointCloud*>(cloud)->getBoundingBox(low, high); // computed on first use
				bounds.extend(inView(*cloud, low, input));
				bounds.extend(inView(*cloud, high, input));
			}
			return bounds;
		}

		std::vector<Eigen::Vector3d> sensorsOf(const ccPointCloud& cloud, const Input& input)
		{
			std::vector<Eigen::Vector3d> positions;
			for (unsigned i = 0; i < cloud.getChildrenNumber(); ++i)
			{
				const ccHObject* child = cloud.getChild(i);
				CCVector3        center;
				if (child->isA(CC_TYPES::GBL_SENSOR) && static_cast<const ccGBLSensor*>(child)->getActiveAbsoluteCenter(center))
					positions.push_back(inView(cloud, center, input));
			}
			return positions;
		}

		void addSensors(const std::vector<const ccPointCloud*>& clouds, Input& input)
		{
			const Bounds                              bounds = boundsOf(clouds, input);
			std::vector<std::vector<Eigen::Vector3d>> sensors;
			std::size_t                               most = 0, tooFar = 0;
			for (const ccPointCloud* cloud : clouds)
			{
				sensors.push_back(sensorsOf(*cloud, input));
				tooFar += std::erase_if(sensors.back(), [&](const Eigen::Vector3d& p)
				                        { return !(bounds.exteriorDistance(p) < kFarthest_m); });
				most = std::max(most, sensors.back().size());
			}
			if (tooFar > 0)
				input.stationText = QString("%1 sensors are more than %2 m from the points and are ignored").arg(tooFar).arg(kFarthest_m);
			if (most == 0)
				return;
			for (std::size_t i = 0; i < clouds.size(); ++i)
			{
				// Which of several sensors a point belongs to is found out later, for all of them.
				if (most == 1 && clouds.size() > 1)
				{
					const auto station = sensors[i].empty() ? StationView::kUnknown : static_cast<std::uint16_t>(input.stations.size());
					input.stationOfPoint.insert(input.stationOfPoint.end(), clouds[i]->size(), station);
				}
				input.stations.insert(input.stations.end(), sensors[i].begin(), sensors[i].end());
			}
		}

		const ccScalarField* idField(const ccPointCloud& cloud)
		{
			for (unsigned i = 0; i < cloud.getNumberOfScalarFields(); ++i)
			{
				const QString name = QString(cloud.getScalarFieldName(static_cast<int>(i))).replace('_', ' ');
				if (name.compare(kIdField, Qt::CaseInsensitive) == 0)
					return static_cast<const ccScalarField*>(cloud.getScalarField(static_cast<int>(i)));
			}
			return nullptr;
		}

		int idOf(const ccScalarField& field, unsigned point)
		{
			const ScalarType value = field.getValue(point);
			return CCCoreLib::ScalarField::ValidValue(value) ? static_cast<int>(static_cast<double>(value) + field.getGlobalShift()) : -1;
		}

		void addIds(const std::vector<const ccPointCloud*>& clouds, const std::vector<KnownStation>& known, const QString& file, Input& input)
		{
			int smallest = std::numeric_limits<int>::max(), largest = 0;
			for (const ccPointCloud* cloud : clouds)
			{
				const ccScalarField* field = idField(*cloud);
				if (!field)
					return;
				for (unsigned i = 0; i < cloud->size(); ++i)
				{
					if (const int id = idOf(*field, i); id >= 0)
						smallest = std::min(smallest, id), largest = std::max(largest, id);
				}
			}
			if (largest == 0) // LAS: none
				return;
			const StationIds ids(known, smallest);
			input.stationOfPoint.reserve(input.view.count);
			std::size_t named = 0;
			for (const ccPointCloud* cloud : clouds)
			{
				const ccScalarField& field = *idField(*cloud);
				for (unsigned i = 0; i < cloud->size(); ++i)
				{
					input.stationOfPoint.push_back(ids.indexOf(idOf(field, i)));
					named += input.stationOfPoint.back() != StationView::kUnknown;
				}
			}
			if (named == 0)
				throw Error(ErrorCode::BadFile, QString("no point of the cloud '%1' bears the id of a station in '%2': its %3 begins at %4, give the file the same ids").arg(clouds.front()->getName(), file, kIdField).arg(smallest).toStdString());
		}

		void addFile(const std::vector<const ccPointCloud*>& clouds, const QString& file, Input& input)
		{
			const std::vector<KnownStation> known  = readStations(QFile::encodeName(file).toStdString());
			const Bounds                    bounds = boundsOf(clouds, input);
			for (const KnownStation& station : known)
			{
				const Eigen::Vector3d p = station.position - input.view.origin;
				if (const double distance = bounds.exteriorDistance(p); !(distance < kFarthest_m))
					throw Error(ErrorCode::BadFile, QString("the station at (%1, %2, %3) of '%4' is %5 m from the cloud: give both in the same coordinates").arg(station.position.x(), 0, 'f', 2).arg(station.position.y(), 0, 'f', 2).arg(station.position.z(), 0, 'f', 2).arg(file).arg(distance, 0, 'f', 0).toStdString());
				input.stations.push_back(p);
			}
			addIds(clouds, known, file, input);
		}
	} // namespace

	void addStations(const std::vector<const ccPointCloud*>& clouds, const QString& file, Input& input)
	{
		if (file.isEmpty())
			addSensors(clouds, input);
		else
			addFile(clouds, file, input);
		if (input.stations.empty())
			return;
		input.view.stations = {input.stations, input.stationOfPoint.empty() ? nullptr : input.stationOfPoint.data()};
		const auto known    = input.stationOfPoint.size() - static_cast<std::size_t>(std::count(input.stationOfPoint.begin(), input.stationOfPoint.end(), StationView::kUnknown));
		QString    whose    = "every point is its";
		if (!input.stationOfPoint.empty())
			whose = QString("%1 % of the points name theirs").arg(100.0 * static_cast<double>(known) / static_cast<double>(input.view.count), 0, 'f', 1);
		else if (input.stations.size() > 1)
			whose = "which point is whose follows from what they can see";
		input.stationText = QString("%1 %2 of the scanner, %3").arg(input.stations.size()).arg(input.stations.size() == 1 ? "station" : "stations").arg(whose) + (input.stationText.isEmpty() ? QString() : QString("; " + input.stationText));
	}
} // namespace s2b
