// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileDialog>
#include <optional>

class S2BEpsgField;

//! Where a model is written, in which schema, and what its coordinates are of
/** Qt's own dialog, as the native ones take no fields of ours. **/
class S2BExportDlg : public QFileDialog
{
	Q_OBJECT

  public:
	//! \param fileName is proposed, in the folder of last time
	explicit S2BExportDlg(const QString& fileName, QWidget* parent = nullptr);

	QString path() const;
	QString schema() const;
	//! Nothing when the field is empty
	std::optional<int> epsg() const;

	//! Stays open, and says why, when the code is none
	void accept() override;

  private:
	S2BEpsgField* m_epsg = nullptr;
};
