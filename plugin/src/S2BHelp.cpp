// SPDX-License-Identifier: GPL-3.0-or-later
// The documents of the project as they are (docs/*.md), compiled in.
#include "S2BHelp.h"

#include <QDialog>
#include <QImage>
#include <QListWidget>
#include <QMainWindow>
#include <QPointer>
#include <QSplitter>
#include <QTextBrowser>
#include <QTextFrame>
#include <QTextTable>
#include <QVBoxLayout>
#include <array>
#include <ccMainAppInterface.h>

namespace s2b
{
	namespace
	{
		constexpr int     kPageWidth_px = 720;
		const char* const kFolder       = "qrc:/CC/plugin/qScanToBim/docs/";

		struct Page
		{
			const char* file;
			const char* title;
		};
		const std::array<Page, 13> kPages{{
		    {"user_guide.md", "User guide"},
		    {"parameters.md", "Parameters and presets"},
		    {"corrections.md", "Corrections"},
		    {"labels.md", "Labels"},
		    {"segmentation.md", "Labels from a model"},
		    {"training.md", "Training a model"},
		    {"conventions.md", "Conventions"},
		    {"ifc.md", "The IFC file"},
		    {"validation_report.md", "Reading the report"},
		    {"validation.md", "The validation's figures"},
		    {"method.md", "The method"},
		    {"simulator.md", "Simulated surveys"},
		    {"bench.md", "Benchmarks"},
		}};

		//! Markdown with tables that have lines and pictures that fit
		class Browser : public QTextBrowser
		{
		  public:
			using QTextBrowser::QTextBrowser;

			void open(const QUrl& url)
			{
				setSource(url);
				polish();
			}

			QVariant loadResource(int type, const QUrl& name) override
			{
				const QVariant resource = QTextBrowser::loadResource(type, name);
				if (type != QTextDocument::ImageResource)
				{
					// What a document refers to beside other documents: a schema, the IDS. Their own tags are no page's.
					const bool isPage = name.fileName().endsWith(".md");
					return isPage ? resource : QVariant("<pre>" + QString::fromUtf8(resource.toByteArray()).toHtmlEscaped() + "</pre>");
				}
				const QImage image = resource.canConvert<QImage>() && !resource.value<QImage>().isNull() ? resource.value<QImage>() : QImage::fromData(resource.toByteArray());
				return image.width() > kPageWidth_px ? image.scaledToWidth(kPageWidth_px, Qt::SmoothTransformation) : image;
			}

			void polish()
			{
				for (QTextFrame* frame : document()->rootFrame()->childFrames())
				{
					auto* table = qobject_cast<QTextTable*>(frame);
					if (!table)
						continue;
					QTextTableFormat format = table->format();
					format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
					format.setBorderBrush(palette().color(QPalette::Mid));
					format.setBorder(1);
					format.setBorderCollapse(true);
					format.setCellPadding(4);
					format.setTopMargin(6);
					format.setBottomMargin(6);
					table->setFormat(format);
				}
			}
		};

		QDialog* makeWindow(QWidget* parent)
		{
			auto* window = new QDialog(parent); // deleted when it is closed
			window->setObjectName("S2BHelp");
			window->setWindowTitle("Scan to BIM: help");
			window->setAttribute(Qt::WA_DeleteOnClose);
			auto* pages   = new QListWidget;
			auto* browser = new Browser;
			pages->setObjectName("pages");
			browser->setObjectName("page");
			browser->setOpenExternalLinks(true);
			browser->document()->setDocumentMargin(16);
			for (const Page& page : kPages)
				pages->addItem(page.title);
			pages->setMaximumWidth(200);
			QObject::connect(pages, &QListWidget::currentRowChanged, browser, [browser](int row)
			                 {
				                 if (row >= 0)
					                 browser->open(QUrl(QString(kFolder) + kPages[static_cast<std::size_t>(row)].file)); });
			// A link from one document to another is followed in the list.
			QObject::connect(browser, &QTextBrowser::sourceChanged, pages, [browser, pages](const QUrl& url)
			                 {
				                 const QSignalBlocker quiet(pages);
				                 for (std::size_t i = 0; i < kPages.size(); ++i)
				                 {
					                 if (url.fileName() == kPages[i].file)
						                 pages->setCurrentRow(static_cast<int>(i));
				                 }
				                 browser->polish(); });
			auto* splitter = new QSplitter;
			splitter->addWidget(pages);
			splitter->addWidget(browser);
			splitter->setStretchFactor(1, 1);
			splitter->setSizes({190, 850});
			auto* column = new QVBoxLayout(window);
			column->setContentsMargins(0, 0, 0, 0);
			column->addWidget(splitter);
			window->resize(1040, 760);
			pages->setCurrentRow(0);
			return window;
		}
	} // namespace

	void showHelp(ccMainAppInterface& app)
	{
		static QPointer<QDialog> window;
		if (!window)
			window = makeWindow(app.getMainWindow());
		window->show();
		window->raise();
		window->activateWindow();
	}
} // namespace s2b
