// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BValidationParameters.h"

#include "core/base/error.h"
#include "core/base/nearest_name.h"

#include <algorithm>
#include <functional>
#include <string_view>
#include <vector>

namespace s2b
{
	namespace
	{
		using validation::ValidationParams;

		struct Row
		{
			const char*                                    name;
			double                                         minimum;
			double                                         maximum;
			std::function<void(ValidationParams&, double)> set;
		};

		const std::vector<Row>& table()
		{
			static const std::vector<Row> kTable = []
			{
				std::vector<Row> rows{
				    {"validation.deviationRange", 0.005, 2.0, [](ValidationParams& p, double v)
				     { p.deviationRange_m = v; }},
				    {"validation.minimumCoverage", 0.0, 1.0, [](ValidationParams& p, double v)
				     { p.minimumCoverage = v; }},
				    {"validation.minimumMatch", 0.01, 1.0, [](ValidationParams& p, double v)
				     { p.minimumMatch = v; }},
				    {"validation.tolerance", 10, 50, [](ValidationParams& p, double v)
				     { p.tolerance = static_cast<int>(v); }},
				};
				static constexpr const char* kLimits[] = {"validation.loa10", "validation.loa20", "validation.loa30", "validation.loa40", "validation.loa50"};
				for (std::size_t i = 0; i < std::size(kLimits); ++i)
					rows.push_back({kLimits[i], 0.0001, 1.0, [i](ValidationParams& p, double v)
					                { p.loaLimit_m[i] = v; }});
				return rows;
			}();
			return kTable;
		}

		[[noreturn]] void fail(const QString& sentence)
		{
			throw Error(ErrorCode::BadParameter, sentence.toStdString());
		}
	} // namespace

	bool setValidationParameter(ValidationParams& params, const QString& assignment)
	{
		const QString name = assignment.section('=', 0, 0).trimmed();
		if (!name.startsWith("validation.", Qt::CaseInsensitive))
			return false;
		const auto row = std::find_if(table().begin(), table().end(), [&](const Row& r)
		                              { return name.compare(r.name, Qt::CaseInsensitive) == 0; });
		if (row == table().end())
		{
			std::vector<std::string_view> names;
			for (const Row& r : table())
				names.emplace_back(r.name);
			fail(QString("there is no parameter '%1', the nearest is '%2' (all of them: %3)").arg(name, QString::fromStdString(std::string(nearestName(name.toStdString(), names))), QString::fromStdString(joinNames(names))));
		}
		bool         isNumber = false;
		const double value    = assignment.section('=', 1).trimmed().toDouble(&isNumber);
		if (!isNumber || !(value >= row->minimum && value <= row->maximum))
			fail(QString("the parameter '%1' takes a number from %2 to %3, not '%4'").arg(row->name).arg(row->minimum).arg(row->maximum).arg(assignment.section('=', 1)));
		if (QString(row->name) == "validation.tolerance" && value != 10.0 && value != 20.0 && value != 30.0 && value != 40.0 && value != 50.0)
			fail(QString("validation.tolerance is a level of accuracy, 10, 20, 30, 40 or 50, not '%1'").arg(assignment.section('=', 1)));
		row->set(params, value);
		return true;
	}

	void checkValidationParameters(const ValidationParams& params)
	{
		for (std::size_t i = 1; i < params.loaLimit_m.size(); ++i)
		{
			if (params.loaLimit_m[i] >= params.loaLimit_m[i - 1])
				fail(QString("validation.loa%1 has to be smaller than validation.loa%2").arg(10 * (i + 1)).arg(10 * i));
		}
	}
} // namespace s2b
