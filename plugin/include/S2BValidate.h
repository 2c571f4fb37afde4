// SPDX-License-Identifier: GPL-3.0-or-later
// A validation as the command line and the window run it: files in, figures, report and deviations out.
#pragma once

#include "core/base/context.h"
#include "core/cloud/point_cloud.h"
#include "core/report/report.h"
#include "core/validation/validation.h"

#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class ccPointCloud;

namespace s2b
{
	//! What was compared, and how it came out
	struct ValidationOutcome
	{
		std::optional<validation::Bim> truth; //!< nothing: one model against the points
		validation::Bim                result;
		validation::Validation         figures;
		validation::ValidationParams   params;
	};

	//! What the report says besides the figures
	struct ReportText
	{
		QString                                          cloudName;
		const Building*                                  building = nullptr; //!< of this run; may be null
		std::vector<std::pair<std::string, std::string>> parameters;
	};

	//! Reads a model to compare. Reading goes on in a thread of its own, so that a cancel is heard at once.
	/** \param near a point of the cloud or of the other model: decides whether a map conversion is applied
	    \throws Error{BadFile}, Cancelled
	**/
	validation::Bim readModel(const QString& path, const std::optional<Eigen::Vector3d>& near, const Context& context);

	//! Reads a ground truth: IFC, the CV4AEC challenge's JSON, or a simulated survey's own
	/** \param storeys names or GUIDs of those to ask for; empty: all
	    \throws Error{BadFile, BadParameter}, Cancelled
	**/
	validation::Bim readGroundTruth(const QString& path, const std::optional<Eigen::Vector3d>& near, const QStringList& storeys, const Context& context);

	//! The middle of the points' box, in world coordinates
	Eigen::Vector3d middleOf(const CloudView& cloud);

	//! Found out before minutes of work: a model that lies somewhere else than the points
	/** \throws Error{BadFile} that names the file and the distance **/
	void checkPlace(const validation::Bim& bim, const CloudView& cloud);

	//! Compares. Distances are per point where there is a cloud.
	/** \param truth may be null when there is a cloud
	    \param cloud may be null when there is a truth
	    \throws Error{BadFile}, Cancelled
	**/
	ValidationOutcome compareModels(std::optional<validation::Bim> truth, validation::Bim result, const CloudView* cloud, const validation::ValidationParams& params, const Context& context);

	//! What a report is made from; borrows everything
	report::ReportInput reportInput(const ValidationOutcome& outcome, const CloudView* cloud, const ReportText& text);

	//! The main figures, one line each
	QStringList validationSummary(const ValidationOutcome& outcome);

	//! "<folder>/<base>_report" of a file
	QString defaultReportFolder(const QString& path);

	//! The part [from, to] of a run: its progress is told as that of the whole
	Context partOf(const Context& whole, double from, double to);

	//! The name of the scalar field
	inline constexpr char kDeviationField[] = "S2B deviation";

	//! A copy of the cloud with the signed distances as its displayed scalar field, blue inside and red outside
	/** \param first index of the cloud's first point in the deviation's
	    \param limit_m where the colours end
	    \throws std::bad_alloc
	**/
	std::unique_ptr<ccPointCloud> deviationCopy(const ccPointCloud& cloud, const validation::CloudDeviation& deviation, std::size_t first, double limit_m);
} // namespace s2b
