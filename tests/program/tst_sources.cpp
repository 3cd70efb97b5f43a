// SPDX-License-Identifier: GPL-3.0-or-later

// Nothing in the sources waits in an event loop of its own, which would stop the program for ever in a browser: dialogs
// and menus are opened with open() and popup(), and answer by signals.

#include "tests/support/files.h"
#include "tests/support/suite.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QTest>

using namespace slidercrank;

namespace tst_sources
{

const QString kRoot = SLIDERCRANK_SOURCE_DIR "/";

/// Matches exec() of any object, static functions that show a dialog and return its answer, and loops that handle
/// events.
const QRegularExpression kWaiting("\\bexec\\s*\\(|\\bprocessEvents\\b|\\bQEventLoop\\b|"
                                  "\\bQMessageBox::(about|aboutQt|critical|information|question|warning)\\b|"
                                  "\\bQ(Input|File|Color|Font)Dialog::get\\w+");

/// The application's own loop, and that in which a video is written, which a browser cannot do.
const QStringList kAllowed{"app/window.cpp: QApplication::exec()",
                           "ui/window/exports.cpp: QCoreApplication::processEvents()"};

/// Returns "file: expression" for each line that waits.
QStringList waitingExpressions(const QString &folder)
{
    QStringList expressions;
    QDirIterator files(kRoot + folder, {"*.cpp", "*.h"}, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString path = files.next();
        for (const QByteArray &bytes : contentOf(path).split('\n')) {
            const QString line = QString::fromUtf8(bytes).section("//", 0, 0);
            if (line.contains(kWaiting)) {
                static const QRegularExpression kExpression(
                    "[\\w:.>-]*(exec|processEvents|QEventLoop|Dialog::get|QMessageBox::)[\\w:]*\\s*\\(?\\)?");
                expressions += path.mid(kRoot.size()) + ": " + kExpression.match(line).captured();
            }
        }
    }
    return expressions;
}

class TestSources : public QObject
{
    Q_OBJECT

private slots:
    void nothingWaitsInAnEventLoopOfItsOwn()
    {
        QStringList expressions = waitingExpressions("app") + waitingExpressions("ui") + waitingExpressions("core");
        for (const QString &allowed : kAllowed) {
            QVERIFY2(expressions.removeOne(allowed),
                     qPrintable(allowed + " is no longer there: " + expressions.join('\n')));
        }
        QCOMPARE(expressions, QStringList());
    }

    void findsEachKindOfWaiting()
    {
        const QStringList waiting{"dialog.exec();",
                                  "menu->exec(position)",
                                  "QMessageBox::about(this, title, text);",
                                  "QInputDialog::getDouble(window, title)",
                                  "QFileDialog::getSaveFileName()",
                                  "QColorDialog::getColor()",
                                  "QEventLoop loop;",
                                  "qApp->processEvents();"};
        for (const QString &line : waiting) {
            QVERIFY2(line.contains(kWaiting), qPrintable(line));
        }
        for (const QString line : {"dialog->open();", "QMessageBox::Save | QMessageBox::Discard", "menu->popup(p);",
                                   "connect(question, &QMessageBox::finished, this)"}) {
            QVERIFY2(!line.contains(kWaiting), qPrintable(line));
        }
    }
};

const Suite<TestSources> suite("tst_sources");

} // namespace tst_sources

#include "tst_sources.moc"
