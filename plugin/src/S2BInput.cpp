// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BInput.h"

#include "S2BSegment.h"
#include "S2BStations.h"
#include "core/base/error.h"

#include <QStringList>
#include <algorithm>
#include <ccPointCloud.h>
#include <ccScalarField.h>
#include <cmath>

namespace s2b
{
	namespace
	{
		static_assert(sizeof(CCVector3) == 3 * sizeof(float), "CloudCompare's points are read in place as three floats");

		constexpr double kCoarse_m = 1.0e5; // beyond it neighbouring floats are 8 mm apart: more than a wall's tolerance
		constexpr int    kNoCode   = -1;

		[[noreturn]] void fail(ErrorCode code, const QString& sentence)
		{
			throw Error(code, sentence.toStdString());
		}

		// Readers of CloudCompare show the underscores of a file's field names as spaces: both spellings are found.
		QString plainName(QString name)
		{
			return name.replace('_', ' ').toLower();
		}

		const ccScalarField* findField(const ccPointCloud& cloud, const QString& name)
		{
			for (unsigned i = 0; i < cloud.getNumberOfScalarFields(); ++i)
			{
				if (plainName(name) == plainName(cloud.getScalarFieldName(static_cast<int>(i))))
					return static_cast<const ccScalarField*>(cloud.getScalarField(static_cast<int>(i)));
			}
			return nullptr;
		}

		QString fieldNames(const ccPointCloud& cloud)
		{
			QStringList names;
			for (unsigned i = 0; i < cloud.getNumberOfScalarFields(); ++i)
				names << cloud.getScalarFieldName(static_cast<int>(i));
			return names.isEmpty() ? QString("it has no scalar field") : "it has: " + names.join(", ");
		}

		// Once in a million points: a fraction of a millisecond's work.
		void pollCancel(const Context& context, unsigned i)
		{
			if ((i & 0xFFFFFu) == 0)
				context.checkCancelled();
		}

		void checkPrecision(const ccPointCloud& cloud, const Context& context)
		{
			double largest = 0;
			for (unsigned i = 0; i < cloud.size(); ++i)
			{
				pollCancel(context, i);
				const CCVector3* p = cloud.getPoint(i);
				const double     m = std::max({std::abs(p->x), std::abs(p->y), std::abs(p->z)});
				if (!std::isfinite(p->x) || !std::isfinite(p->y) || !std::isfinite(p->z))
				{
					fail(ErrorCode::BadCoordinates, QString("point %1 of the cloud '%2' has a coordinate that is not a number: remove such points first").arg(i + 1).arg(cloud.getName()));
				}
				largest = std::max(largest, m);
			}
			largest /= cloud.getGlobalScale();
			if (largest < kCoarse_m)
				return;
			const double spacing = std::exp2(std::floor(std::log2(largest)) - 23);
			fail(ErrorCode::BadCoordinates,
			     QString("the coordinates of the cloud '%1' reach %2 m and are kept in steps of %3 m only: open it with -O -GLOBAL_SHIFT AUTO FILE, or accept the global shift in CloudCompare's window")
			         .arg(cloud.getName())
			         .arg(largest, 0, 'f', 0)
			         .arg(spacing, 0, 'g', 2));
		}

		// Codes of the built-in maps and of LAS are small: a table instead of a search for each of millions of points.
		class CodeTable
		{
		  public:
			explicit CodeTable(const LabelMap& map)
			{
				for (const auto& [code, label] : map.classOfCode)
				{
					if (code >= 0 && code < static_cast<int>(m_label.size()))
						m_label[static_cast<std::size_t>(code)] = static_cast<int>(label);
				}
				m_map = &map;
			}
			int find(int code) const
			{
				if (code >= 0 && code < static_cast<int>(m_label.size()))
					return m_label[static_cast<std::size_t>(code)];
				const auto it = m_map->classOfCode.find(code);
				return it == m_map->classOfCode.end() ? kNoCode : static_cast<int>(it->second);
			}

		  private:
			const LabelMap*      m_map   = nullptr;
			std::array<int, 256> m_label = []
			{
				std::array<int, 256> none{};
				none.fill(kNoCode);
				return none;
			}();
		};

		void readLabels(const ccPointCloud& cloud, const ccScalarField& field, const LabelMap& map, Input& input, const Context& context)
		{
			const CodeTable            table(map);
			const double               shift = field.getGlobalShift();
			std::map<int, std::size_t> unknown;
			for (unsigned i = 0; i < cloud.size(); ++i)
			{
				pollCancel(context, i);
				const ScalarType value = field.getValue(i);
				int              label = static_cast<int>(Label::Unassigned);
				if (CCCoreLib::ScalarField::ValidValue(value)) // CloudCompare's NaN says "no value here"
				{
					const double code = static_cast<double>(value) + shift;
					if (code != std::floor(code) || std::abs(code) > 1.0e9)
					{
						fail(ErrorCode::BadLabels, QString("the field '%1' of the cloud '%2' is not made of class codes, point %3 has %4: choose another field with -LABELS, or use -GEOMETRY_ONLY").arg(field.getName(), cloud.getName()).arg(i + 1).arg(code));
					}
					label = table.find(static_cast<int>(code));
					if (label == kNoCode)
					{
						++unknown[static_cast<int>(code)];
						label = static_cast<int>(Label::Unassigned);
					}
				}
				input.ownLabels.push_back(static_cast<std::uint8_t>(label));
				++input.labelCounts[static_cast<std::size_t>(label)];
			}
			if (unknown.empty())
				return;
			QStringList codes;
			for (const auto& [code, count] : unknown)
			{
				if (codes.size() == 12)
				{
					codes << "...";
					break;
				}
				codes << QString("%1 (%2 points)").arg(code).arg(count);
			}
			fail(ErrorCode::BadLabels, QString("the label map '%1' has no class for code %2 of the field '%3' in the cloud '%4': choose another map with -LABEL_MAP (s2b, s3dis, scannet, asprs or a TOML file), or use -GEOMETRY_ONLY").arg(QString::fromStdString(map.name), codes.join(", "), field.getName(), cloud.getName()));
		}

		// How sure Segment... was, where the labels are its own.
		void readConfidence(const std::vector<const ccPointCloud*>& clouds, Input& input)
		{
			if (input.labelField != kClassField)
				return;
			std::vector<std::uint8_t> confidence;
			confidence.reserve(input.view.count);
			for (const ccPointCloud* cloud : clouds)
			{
				const ccScalarField* field = findField(*cloud, kConfidenceField);
				if (!field)
					return; // deleted by hand: then all labels count the same
				for (unsigned i = 0; i < cloud->size(); ++i)
				{
					const double value = static_cast<double>(field->getValue(i));
					confidence.push_back(static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(std::isnan(value) ? 0.0 : value, 0.0, 1.0))));
				}
			}
			input.ownConfidence   = std::move(confidence);
			input.view.confidence = input.ownConfidence.data();
		}

		// A single cloud's colours are read in place, as its points are.
		void viewColors(const std::vector<const ccPointCloud*>& clouds, Input& input)
		{
			if (!std::all_of(clouds.begin(), clouds.end(), [](const ccPointCloud* cloud)
			                 { return cloud->hasColors(); }))
				return;
			if (clouds.size() == 1)
			{
				static_assert(sizeof(ccColor::Rgba) == 4 && sizeof(ColorCompType) == 1);
				input.view.rgb       = clouds.front()->rgbaColors()->front().rgba;
				input.view.rgbStride = sizeof(ccColor::Rgba);
				return;
			}
			input.ownColors.reserve(3 * input.view.count);
			for (const ccPointCloud* cloud : clouds)
			{
				for (const ccColor::Rgba& color : *cloud->rgbaColors())
					input.ownColors.insert(input.ownColors.end(), {color.r, color.g, color.b});
			}
			input.view.rgb = input.ownColors.data();
		}

		void readAllLabels(const std::vector<const ccPointCloud*>& clouds, const LabelChoice& choice, Input& input, const Context& context)
		{
			std::vector<const ccScalarField*> fields;
			for (const ccPointCloud* cloud : clouds)
			{
				const QString name = choice.field.isEmpty() ? defaultLabelField(*cloud) : choice.field;
				fields.push_back(name.isEmpty() ? nullptr : findField(*cloud, name));
				if (!fields.back() && !choice.field.isEmpty())
				{
					fail(ErrorCode::BadLabels, QString("the cloud '%1' has no scalar field '%2' for -LABELS, %3").arg(cloud->getName(), choice.field, fieldNames(*cloud)));
				}
				if (!fields.back())
				{
					input.warning = QString("the cloud '%1' has no labels (no scalar field Classification or label, %2)").arg(cloud->getName(), fieldNames(*cloud));
					return;
				}
			}
			input.ownLabels.reserve(input.view.count);
			for (std::size_t i = 0; i < clouds.size(); ++i)
				readLabels(*clouds[i], *fields[i], fields[i]->getName() == QString(kClassField) ? builtInLabelMap("s2b") : choice.map, input, context);
			if (input.labelCounts[static_cast<std::size_t>(Label::Unassigned)] == input.view.count)
			{
				input.warning = QString("the field '%1' leaves every point unassigned").arg(fields.front()->getName());
				input.ownLabels.clear();
				input.ownLabels.shrink_to_fit();
				return;
			}
			// Such labels (an airborne survey's, say) would leave the building without walls.
			if (input.labelCounts[static_cast<std::size_t>(Label::Wall)] + input.labelCounts[static_cast<std::size_t>(Label::Column)] == 0)
			{
				input.warning = QString("the field '%1' with the map '%2' names no wall and no column").arg(fields.front()->getName(), QString::fromStdString(choice.map.name));
				input.ownLabels.clear();
				input.ownLabels.shrink_to_fit();
				return;
			}
			input.labelField  = fields.front()->getName();
			input.view.labels = input.ownLabels.data();
			readConfidence(clouds, input);
		}

		// One cloud as it is: a view. Several, or a scaled one: a copy about the first one's origin.
		void viewPoints(const std::vector<const ccPointCloud*>& clouds, Input& input, const Context& context)
		{
			const ccPointCloud& first  = *clouds.front();
			const CCVector3d    origin = -1.0 * first.getGlobalShift(); // global = local / scale - shift
			input.view.origin          = {origin.x, origin.y, origin.z};
			if (clouds.size() == 1 && first.getGlobalScale() == 1.0)
			{
				input.view.xyz = first.getPoint(0)->u;
				return;
			}
			input.ownPoints.reserve(3 * input.view.count);
			for (const ccPointCloud* cloud : clouds)
			{
				for (unsigned i = 0; i < cloud->size(); ++i)
				{
					pollCancel(context, i);
					const CCVector3d p = cloud->toGlobal3d(*cloud->getPoint(i)) - origin;
					for (const double c : p.u)
					{
						if (std::abs(c) >= kCoarse_m)
							fail(ErrorCode::BadCoordinates, QString("the clouds '%1' and '%2' are more than 100 km apart and can't be one building: reconstruct them one by one").arg(first.getName(), cloud->getName()));
						input.ownPoints.push_back(static_cast<float>(c));
					}
				}
			}
			input.view.xyz = input.ownPoints.data();
		}
	} // namespace

	QString defaultLabelField(const ccPointCloud& cloud)
	{
		for (const char* name : {kClassField, "Classification", "label"})
		{
			if (const ccScalarField* field = findField(cloud, name))
				return field->getName();
		}
		return {};
	}

	std::map<int, std::size_t> countCodes(const ccPointCloud& cloud, const QString& field, bool& hasFractions)
	{
		constexpr std::size_t      kTooMany = 1000; // more codes than that are no classes
		std::map<int, std::size_t> counts;
		hasFractions = false;
		if (const ccScalarField* values = findField(cloud, field))
		{
			int          last      = 0;
			std::size_t* lastCount = nullptr; // neighbours often share their class
			for (const ScalarType value : *values)
			{
				const double code = static_cast<double>(value) + values->getGlobalShift();
				if (!(std::abs(code) < 1.0e9))
					continue;
				const int whole = static_cast<int>(std::floor(code));
				hasFractions    = hasFractions || code != whole;
				if (!lastCount || whole != last)
				{
					if (hasFractions || counts.size() > kTooMany)
						break;
					last      = whole;
					lastCount = &counts[whole];
				}
				++*lastCount;
			}
			hasFractions = hasFractions || counts.size() > kTooMany;
		}
		return counts;
	}

	Input makeInput(const std::vector<const ccPointCloud*>& clouds, const LabelChoice& labels, const QString& stationFile, const Context& context)
	{
		Input input;
		if (clouds.empty())
			fail(ErrorCode::EmptyCloud, "there is no point cloud: open one first");
		for (const ccPointCloud* cloud : clouds)
		{
			if (cloud->size() == 0)
				fail(ErrorCode::EmptyCloud, QString("the cloud '%1' has no points").arg(cloud->getName()));
			checkPrecision(*cloud, context);
			input.view.count += cloud->size();
		}
		viewPoints(clouds, input, context);
		viewColors(clouds, input);
		if (labels.use)
			readAllLabels(clouds, labels, input, context);
		addStations(clouds, stationFile, input);
		return input;
	}
} // namespace s2b
