// SPDX-License-Identifier: GPL-3.0-or-later
// The options of -S2B: one table that parses, checks and documents them.
#pragma once

#include "core/labels/label.h"
#include "core/pipeline/pipeline.h"
#include "core/validation/validation.h"

#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace s2b
{
	//! Everything that one -S2B run was asked for, checked
	struct CommandOptions
	{
		PipelineOptions    pipeline;
		QString            labelField; //!< empty: the usual names are looked for
		LabelMap           labelMap;
		QString            stationFile;     //!< empty: the clouds' sensors count
		bool               segment = false; //!< label the points with a model first
		QString            modelPath;       //!< empty: the shipped one
		QString            ifcPath;         //!< empty: <cloud>.ifc beside the cloud
		QString            schema = "IFC4";
		std::optional<int> epsg;            //!< what the coordinates are of: gives IfcMapConversion
		unsigned           threads     = 0; //!< 0: all
		std::uint64_t      seed        = 1;
		bool               reconstruct = true; //!< false: -STAGES none, the IFC file is there already and only read

		QString                      truthPath;    //!< empty: no ground truth
		QStringList                  storeys;      //!< of the truth; empty: all
		QString                      reportFolder; //!< empty: beside the IFC file
		validation::ValidationParams validation;

		//! Whether anything is to be measured
		bool validates() const
		{
			return !truthPath.isEmpty() || !reportFolder.isEmpty() || !reconstruct;
		}
	};

	//! The value of -EPSG, wherever it is given
	/** \throws Error{BadParameter} in one sentence when it is no code of the registry **/
	int epsgCode(const QString& text);

	//! One row of the table
	struct CommandOption
	{
		const char*                                          name;       //!< without the dash
		const char*                                          value;      //!< what follows it, empty for a switch
		bool                                                 repeatable; //!< may be given several times
		const char*                                          help;       //!< one sentence
		std::function<void(CommandOptions&, const QString&)> apply;      //!< throws Error on a value that can't be used
	};

	//! The table, in the order of the documentation
	const std::vector<CommandOption>& commandOptions();

	//! Takes our options off the front of the arguments, and checks all of them before anything runs.
	/** Stops at the first argument that is a command of CloudCompare's own.
	    \param arguments what follows -S2B on the command line
	    \param isOtherCommand says whether a keyword (without its dash) is another command that CloudCompare knows
	    \throws Error in one sentence that names the option and what to do
	**/
	CommandOptions parseCommandOptions(QStringList& arguments, const std::function<bool(const QString&)>& isOtherCommand);
} // namespace s2b
