// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class ccMainAppInterface;

namespace s2b
{
	//! Opens the user guide and the other documents in a window of their own
	void showHelp(ccMainAppInterface& app);
} // namespace s2b
