// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BValidate.h"
#include "core/report/color.h"

#include <ccColorScale.h>
#include <ccPointCloud.h>
#include <ccScalarField.h>

namespace s2b
{
	namespace
	{
		// The colours of the report, ending at the limit: CloudCompare's own scales would end at the farthest point.
		ccColorScale::Shared divergingScale(double limit)
		{
			constexpr int        kSteps = 8;
			ccColorScale::Shared scale  = ccColorScale::Create("S2B deviation");
			for (int i = 0; i <= kSteps; ++i)
			{
				const report::Color color = report::divergingColor(2.0 * i / kSteps - 1.0);
				scale->insert(ccColorScaleElement(static_cast<double>(i) / kSteps, QColor(color.r, color.g, color.b)), false);
			}
			scale->setAbsolute(-limit, limit);
			scale->update();
			return scale;
		}
	} // namespace

	std::unique_ptr<ccPointCloud> deviationCopy(const ccPointCloud& cloud, const validation::CloudDeviation& deviation, std::size_t first, double limit_m)
	{
		// cloneThis() is not const, but changes nothing.
		std::unique_ptr<ccPointCloud> copy(const_cast<ccPointCloud&>(cloud).cloneThis(nullptr, true));
		auto*                         field = new ccScalarField(kDeviationField); // shared, and counted by the cloud
		field->link();
		if (!copy || !field->reserveSafe(cloud.size()))
		{
			field->release();
			throw std::bad_alloc();
		}
		// CloudCompare's distances are in the cloud's own units.
		const double scale = cloud.getGlobalScale();
		for (std::size_t i = first; i < first + cloud.size(); ++i)
			field->addElement(static_cast<ScalarType>(deviation.distance_m[i] * scale));
		field->computeMinAndMax();
		field->setColorScale(divergingScale(limit_m * scale));
		field->showNaNValuesInGrey(true);

		const int old = copy->getScalarFieldIndexByName(kDeviationField);
		if (old >= 0) // of an earlier validation
			copy->deleteScalarField(old);
		const int index = copy->addScalarField(field);
		field->release();
		if (index < 0)
			throw std::bad_alloc();
		copy->setName(cloud.getName() + " [deviation]");
		copy->setCurrentDisplayedScalarField(index);
		copy->showSF(true);
		copy->showSFColorsScale(true);
		copy->setEnabled(true);
		return copy;
	}
} // namespace s2b
