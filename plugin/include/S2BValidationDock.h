// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "S2BDock.h"

#include <QString>
#include <map>
#include <memory>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QStandardItemModel;
class QTableView;
class QTemporaryDir;

namespace s2b
{
	//! A report on disk, and what keeps it there
	struct KeptReport
	{
		QString                        folder;
		std::shared_ptr<QTemporaryDir> temporary; //!< null when the user chose the folder
	};
} // namespace s2b

//! "Scan to BIM: validation": a validation's elements with their errors; a click selects and zooms
class S2BValidationDock : public S2BDock
{
	Q_OBJECT

  public:
	explicit S2BValidationDock(ccMainAppInterface& app);

	//! Tells about a validation that was just made
	void setValidation(const ccHObject* tree, s2b::KeptReport report);

  protected:
	void fill() override;

  private:
	QWidget* makeFilters();
	void     applyFilters();
	void     go(const QModelIndex& index);
	QString  reportFolder() const;
	void     openReport();
	void     exportReport();

	std::map<unsigned, s2b::KeptReport> m_reports; //!< by the unique id of the tree
	QStandardItemModel*                 m_model   = nullptr;
	QSortFilterProxyModel*              m_proxy   = nullptr;
	QTableView*                         m_table   = nullptr;
	QLabel*                             m_title   = nullptr;
	QComboBox*                          m_verdict = nullptr;
	QComboBox*                          m_class   = nullptr;
	QLineEdit*                          m_search  = nullptr;
	QPushButton*                        m_open    = nullptr;
	QPushButton*                        m_export  = nullptr;
};
