// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ccCommandLineInterface.h>

//! -S2B: reconstructs the opened clouds, taken together, and writes an IFC file
/** Its options are the table in S2BOptions.h. Fails with one sentence and without leaving a file. **/
struct S2BCommand : public ccCommandLineInterface::Command
{
	S2BCommand();
	bool process(ccCommandLineInterface& cmd) override;
};
