// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BSegment.h"

#include "S2BInput.h"
#include "core/base/error.h"
#include "core/segmentation/shipped_model.h"

#include <QColor>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <array>
#include <ccColorScale.h>
#include <ccPointCloud.h>
#include <ccScalarField.h>
#include <numeric>

namespace s2b
{
	namespace
	{
		// By code: told apart in the dark and by the colour-blind; walls and slabs light, what is small stands out.
		constexpr std::array<QRgb, kLabelCount> kClassColors{
		    0xff9a9a9a, // unassigned
		    0xffb8a37a, // floor
		    0xffe3dcc8, // ceiling
		    0xff6f9fd8, // wall
		    0xff8e5bb5, // column
		    0xffe07b39, // door
		    0xff4cc9d6, // window
		    0xffc0587e, // beam
		    0xfff2c94c, // stair
		    0xffa0522d, // roof
		    0xff6aa84f, // furniture
		};

		ccColorScale::Shared classScale()
		{
			constexpr double       kCodes  = static_cast<double>(kLabelCount);
			constexpr double       kBorder = 1.0e-6; // two colours side by side: no shades between classes
			ccColorScale::Shared   scale   = ccColorScale::Create("S2B classes");
			ccColorScale::LabelSet labels;
			for (std::size_t i = 0; i < kLabelCount; ++i)
			{
				const QColor color(kClassColors[i]);
				scale->insert(ccColorScaleElement(i == 0 ? 0.0 : static_cast<double>(i) / kCodes + kBorder, color), false);
				scale->insert(ccColorScaleElement(i + 1 == kLabelCount ? 1.0 : static_cast<double>(i + 1) / kCodes - kBorder, color), false);
				labels.insert({static_cast<double>(i), QString::fromStdString(std::string(labelName(static_cast<Label>(i))))});
			}
			scale->setAbsolute(-0.5, kCodes - 0.5);
			scale->setCustomLabels(labels);
			scale->update();
			return scale;
		}

		// Grey for a guess, green for what is sure.
		ccColorScale::Shared confidenceScale()
		{
			ccColorScale::Shared scale = ccColorScale::Create("S2B confidence");
			scale->insert(ccColorScaleElement(0.0, QColor(0x55, 0x2b, 0x2b)), false);
			scale->insert(ccColorScaleElement(0.5, QColor(0xd9, 0xc9, 0x6b)), false);
			scale->insert(ccColorScaleElement(1.0, QColor(0x3a, 0x9d, 0x5d)), false);
			scale->setAbsolute(0.0, 1.0);
			scale->update();
			return scale;
		}

		// Fields are shared, and counted by those who hold them.
		struct Release
		{
			void operator()(ccScalarField* field) const
			{
				field->release();
			}
		};
		using Field = std::unique_ptr<ccScalarField, Release>;

		template <typename Value>
		Field makeField(const char* name, std::size_t first, std::size_t count, const ccColorScale::Shared& scale, Value&& value)
		{
			Field field(new ccScalarField(name));
			field->link();
			if (!field->reserveSafe(static_cast<unsigned>(count)))
				throw std::bad_alloc();
			for (std::size_t i = first; i < first + count; ++i)
				field->addElement(static_cast<ScalarType>(value(i)));
			field->computeMinAndMax();
			field->setColorScale(scale);
			return field;
		}

		int replaceField(ccPointCloud& cloud, const Field& field)
		{
			const int old = cloud.getScalarFieldIndexByName(field->getName());
			if (old >= 0)
				cloud.deleteScalarField(old);
			const int index = cloud.addScalarField(field.get());
			if (index < 0)
				throw std::bad_alloc();
			return index;
		}
	} // namespace

	OnnxModel openModel(const QString& path, unsigned threads)
	{
		if (!path.isEmpty())
			return OnnxModel::load(QFile::encodeName(path).toStdString(), threads);
		if (shippedModel().empty())
			throw Error(ErrorCode::BadFile, "this build brings no segmentation model with it: give one, -SEGMENT FILE.onnx");
		return OnnxModel::fromBytes(shippedModel(), kShippedModelName, threads);
	}

	bool hasShippedModel()
	{
		return !shippedModel().empty();
	}

	QString insteadOfLabels(const Input& input, bool isModel)
	{
		return input.warning + (isModel ? ": taking those of the shipped model, weighed against the geometry" : ": working from the geometry alone");
	}

	QString modelText(const OnnxModel& model)
	{
		const ModelContract& contract = model.contract();
		QStringList          classes;
		for (const Label label : contract.classes)
		{
			const QString name = QString::fromStdString(std::string(labelName(label)));
			if (!classes.contains(name))
				classes << name;
		}
		const char* colour = contract.colour == ColourUse::Required ? "needs colours" : (contract.colour == ColourUse::Optional ? "uses colours where there are any" : "uses no colours");
		return QString("%1 classes (%2), cells of %3 cm, %4").arg(classes.size()).arg(classes.join(", ")).arg(100.0 * contract.cell_m, 0, 'g', 3).arg(colour);
	}

	void segmentInput(Input& input, const OnnxModel& model, const Context& context)
	{
		Segmentation segmentation = segment(input.view, model, {}, context);
		input.ownLabels           = std::move(segmentation.labels);
		input.ownConfidence       = std::move(segmentation.confidence);
		input.labelCounts         = segmentation.counts;
		input.labelField          = QFileInfo(QString::fromStdString(model.name())).fileName();
		input.warning             = QString();
		input.view.labels         = input.ownLabels.data();
		input.view.confidence     = input.ownConfidence.data();
	}

	QString segmentationText(const Input& input)
	{
		const auto  total = static_cast<double>(input.view.count);
		QStringList parts;
		for (std::size_t i = 0; i < kLabelCount; ++i)
		{
			const std::size_t count = input.labelCounts[i];
			if (count)
				parts << QString("%1 %2 (%3 %)").arg(QString::fromStdString(std::string(labelName(static_cast<Label>(i)))), QLocale(QLocale::English).toString(static_cast<qulonglong>(count))).arg(100.0 * static_cast<double>(count) / total, 0, 'f', 1);
		}
		const double sum = std::accumulate(input.ownConfidence.begin(), input.ownConfidence.end(), 0.0);
		return QString("%1; mean confidence %2 %").arg(parts.join(", ")).arg(100.0 * sum / (255.0 * total), 0, 'f', 0);
	}

	void addSegmentationFields(ccPointCloud& cloud, const Input& input, std::size_t first)
	{
		const std::size_t count      = cloud.size();
		const Field       classes    = makeField(kClassField, first, count, classScale(), [&](std::size_t i)
                                        { return input.ownLabels[i]; });
		const Field       confidence = makeField(kConfidenceField, first, count, confidenceScale(), [&](std::size_t i)
                                           { return input.ownConfidence[i] / 255.0; });
		replaceField(cloud, confidence);
		cloud.setCurrentDisplayedScalarField(replaceField(cloud, classes));
		cloud.showSF(true);
		cloud.showSFColorsScale(true);
	}
} // namespace s2b
