// SPDX-License-Identifier: GPL-3.0-or-later
// From CloudCompare's clouds to what the reconstruction reads.
#pragma once

#include "core/base/context.h"
#include "core/cloud/point_cloud.h"
#include "core/labels/label.h"

#include <QString>
#include <array>
#include <map>
#include <vector>

class ccPointCloud;

namespace s2b
{
	//! Which labels to take
	struct LabelChoice
	{
		bool     use = true;
		QString  field; //!< empty: Classification or label, if there
		LabelMap map;
		bool     orModel = false; //!< where there are none of use: those of the shipped model, if there is one
	};

	//! What the reconstruction reads, and what keeps it alive
	/** A single cloud's points are read where CloudCompare has them; only the labels are new (one byte a point).
	    Several clouds, or a scaled one, are brought together in a copy. The clouds have to outlive it.
	**/
	struct Input
	{
		CloudView                            view;
		QString                              labelField; //!< the field that was used, empty without labels
		std::array<std::size_t, kLabelCount> labelCounts{};
		QString                              warning; //!< why there are no labels, the first half of a sentence; empty when all is well
		std::vector<float>                   ownPoints;
		std::vector<std::uint8_t>            ownLabels;
		std::vector<Eigen::Vector3d>         stations;       //!< of the scanner, as far as they are known
		std::vector<std::uint16_t>           stationOfPoint; //!< empty when that is not known, or there is one only
		QString                              stationText;    //!< what is known of them, for people; empty for nothing
		std::vector<std::uint8_t>            ownConfidence;
		std::vector<std::uint8_t>            ownColors;
	};

	//! Name of the field that holds the labels: those of Segment..., or by custom (Classification, label); empty when there is none
	QString defaultLabelField(const ccPointCloud& cloud);

	//! How many points each code of a field has; a value that is not a whole number counts under its floor
	/** \param hasFractions set when such a value was met: then the field holds no labels **/
	std::map<int, std::size_t> countCodes(const ccPointCloud& cloud, const QString& field, bool& hasFractions);

	//! Brings the clouds into the form that the reconstruction reads; the clouds are not changed.
	/** \param stationFile what -STATIONS names; empty: the sensors below the clouds count
	    \throws Error{EmptyCloud} without a point, Error{BadCoordinates} for coordinates whose float spacing is too
	    coarse (beyond 100 km of the local origin: 8 mm), Error{BadLabels} for a field that is not there, that holds no
	    whole numbers, or codes that the map does not know; Error{BadFile} for the stations' file; Cancelled (asked every
	    2^20 points).
	**/
	Input makeInput(const std::vector<const ccPointCloud*>& clouds, const LabelChoice& labels, const QString& stationFile = {}, const Context& context = {});
} // namespace s2b
