// SPDX-License-Identifier: GPL-3.0-or-later
// Labels from an ONNX model: what the command line and the window share.
#pragma once

#include "core/segmentation/segment.h"

#include <QString>
#include <QStringList>

class ccPointCloud;

namespace s2b
{
	struct Input;

	//! The names of the scalar fields; makeInput() knows that the one says how sure the other is
	inline constexpr char kClassField[]      = "S2B class";
	inline constexpr char kConfidenceField[] = "S2B confidence";

	//! Share of a run's progress when a model labels the points before it
	inline constexpr double kLabelled = 0.4;

	//! A model from a file, or the one that this program brings with it
	/** \param path empty: the shipped one
	    \throws Error{BadFile} that names the file and what is wrong with it, or that no model is shipped
	**/
	OnnxModel openModel(const QString& path, unsigned threads);

	//! "4 classes (floor, ceiling, wall, furniture), cells of 3 cm, 12 features, uses colours where there are any"
	QString modelText(const OnnxModel& model);

	//! Labels the input's points: its labels are then the model's, weighed by their confidence
	/** \throws Error, Cancelled as segment() does; the input is unchanged then **/
	void segmentInput(Input& input, const OnnxModel& model, const Context& context);

	//! Whether this build brings a model with it
	bool hasShippedModel();

	//! What becomes of an input without labels of use, for people: why, and what is done instead
	QString insteadOfLabels(const Input& input, bool isModel);

	//! "wall 312,400 (41 %), floor ..." and how sure the model is; of an input that uses a segmentation
	QString segmentationText(const Input& input);

	//! Class and confidence of the cloud's points as scalar fields, the class displayed in its own colours
	/** Everything is made before the cloud is touched. Fields of an earlier run are replaced.
	    \param input that uses a segmentation
	    \param first index of the cloud's first point in it
	    \throws std::bad_alloc
	**/
	void addSegmentationFields(ccPointCloud& cloud, const Input& input, std::size_t first);
} // namespace s2b
