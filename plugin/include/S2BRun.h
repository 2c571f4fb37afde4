// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line and the window share: how an IFC file is written from a run.
#pragma once

#include "core/model/building.h"
#include "core/pipeline/pipeline.h"
#include "ifc/ifc_writer.h"

#include <QString>
#include <mutex>

namespace s2b
{
	//! Options of the IFC file: the run's parameters on record, and a time stamp that is the same for the same input
	/** The time is SOURCE_DATE_EPOCH if that is set, or a constant. **/
	ifc::WriteOptions writeOptions(const PipelineOptions& run, std::uint64_t seed, const QString& projectName, const QString& schema);

	//! "2023-11-14T22:13:20" of SOURCE_DATE_EPOCH, empty where that is not set
	std::string reproducibleTime();

	//! Writes the building
	/** \throws Error when the file can't be written; nothing is left then **/
	void writeModel(const Building& building, const QString& path, const ifc::WriteOptions& options);

	//! Held while IFC is read or written: the library does not take two at a time
	std::mutex& ifcMutex();
} // namespace s2b
