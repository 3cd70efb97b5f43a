// SPDX-License-Identifier: GPL-3.0-or-later

// What there is no memory for in the window's own thread ends with a sentence, and not with the program.

#include "ui/widgets/message_bar.h"
#include "ui/document/session.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"

#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <new>

using namespace slidercrank;

class TestMemory : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
    }

    void theWindowSaysThatThereIsNone()
    {
        MainWindow window;
        window.show();
        QPushButton button(&window);
        connect(&button, &QPushButton::clicked, &button, [] { throw std::bad_alloc(); });
        button.show();
        QTest::mouseClick(&button, Qt::LeftButton);
        const auto *bar = window.findChild<MessageBar *>();
        QVERIFY(bar->isVisibleTo(&window));
        QVERIFY(bar->text().contains(QStringLiteral("not enough memory")));

        // And goes on.
        window.session().setTime(0.25);
        QCOMPARE(window.session().time(), 0.25);
    }

private:
    QTemporaryDir m_settings;
};

int main(int argc, char *argv[])
{
    Application application(argc, argv);
    TestMemory test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_memory.moc"
