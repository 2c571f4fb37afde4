// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.h"

#include <QListWidget>
#include <QTextBlock>
#include <QTextBrowser>

namespace
{

void help(Driver& driver)
{
    driver.action("S2B.Help")->trigger();
    driver.check(driver.waitFor([&] { return driver.shown("S2BHelp") != nullptr; }, 5000), "the user guide opens");
    QWidget* window = driver.shown("S2BHelp");
    if (!window)
        return;
    auto* pages = window->findChild<QListWidget*>("pages");
    auto* page = window->findChild<QTextBrowser*>("page");
    for (int row = pages->count() - 1; row >= 0; --row)
    {
        pages->setCurrentRow(row);
        driver.check(page->toPlainText().size() > 500, QString("\"%1\" is there").arg(pages->item(row)->text()));
        for (QTextBlock block = page->document()->begin(); block.isValid(); block = block.next())
            for (auto part = block.begin(); !part.atEnd(); ++part)
            {
                const QUrl link(part.fragment().charFormat().anchorHref());
                if (!link.isEmpty() && link.isRelative() && !link.path().isEmpty())
                    driver.check(QFile::exists(":" + page->source().resolved(link).path()),
                                 link.path() + " can be followed");
                const QTextImageFormat image = part.fragment().charFormat().toImageFormat();
                if (image.isValid() && image.name().size())
                    driver.check(page->loadResource(QTextDocument::ImageResource, image.name()).isValid(),
                                 image.name() + " is there");
            }
    }
    driver.shoot(window, "help");
    page->setSource(QUrl("qrc:/CC/plugin/qScanToBim/docs/parameters.md"));
    driver.check(pages->currentRow() == 1, "links are followed in the list");
    driver.shoot(window, "help_parameters");
    page->setSource(QUrl("qrc:/CC/plugin/qScanToBim/docs/validation_report.schema.json"));
    driver.check(page->toPlainText().contains("\"$schema\""), "a schema is shown as it is");
    window->close();
}

const Scenario kScenario("help", help);

}  // namespace
