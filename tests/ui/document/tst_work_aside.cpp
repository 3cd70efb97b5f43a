// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.h"
#include "ui/document/work_aside.h"

#include "tests/support/waiting.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <QThreadPool>

#include <algorithm>
#include <atomic>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

using namespace slidercrank;

namespace
{

using Gate = QSemaphore;
using Stop = std::stop_token;
using Progress = WorkAside::Progress;

const auto kNobody = [](const auto &...) { QFAIL("is not to be called"); };

const QList<QVariantList> kOnceOnAndOff{{true}, {false}};

/// Work that says it has begun, then waits to be let through, or to be stopped.
struct Held {
    std::shared_ptr<Gate> begun = std::make_shared<Gate>(0);
    std::shared_ptr<Gate> letThrough = std::make_shared<Gate>(0);
    int value = 0;

    int operator()(const Stop &stop, const Progress &) const
    {
        const std::stop_callback wake(stop, [this] { letThrough->release(); });
        begun->release();
        letThrough->acquire();
        return stop.stop_requested() ? -1 : value;
    }
};

} // namespace

class tst_work_aside : public QObject
{
    Q_OBJECT

private slots:
    void worksInAnotherThreadAndCallsBackInThisOne()
    {
        WorkAside aside;
        QSignalSpy running(&aside, &WorkAside::runningChanged);
        QThread *there = nullptr;
        QThread *here = nullptr;
        QString value;
        aside.start(
            [&](const Stop &, const Progress &) {
                there = QThread::currentThread();
                return QStringLiteral("done");
            },
            [&](const QString &made) {
                here = QThread::currentThread();
                value = made;
                QVERIFY(aside.isRunning());
            },
            kNobody);
        QVERIFY(aside.isRunning());
        QVERIFY(value.isEmpty());
        AWAIT(!aside.isRunning());
        QCOMPARE(value, QStringLiteral("done"));
        QVERIFY(there && there != thread());
        QCOMPARE(here, thread());
        QCOMPARE(QList<QVariantList>(running), kOnceOnAndOff);
    }

    void progressComesInOrderAndBeforeTheValue()
    {
        WorkAside aside;
        Gate heard(0);
        std::vector<double> parts;
        connect(&aside, &WorkAside::progressed, this, [&](double part) {
            parts.push_back(part);
            heard.release();
        });
        std::size_t before = 0;
        aside.start(
            [&](const Stop &, const Progress &progress) {
                progress(0.0); // nothing to tell yet
                progress(0.5);
                heard.acquire(); // it is told while the work goes on
                for (int i = 500'000; i <= 1'000'000; ++i) {
                    progress(i * 1e-6);
                }
                return 0;
            },
            [&](int) { before = parts.size(); }, kNobody);
        AWAIT(!aside.isRunning());
        QCOMPARE(before, parts.size());
        QVERIFY2(parts.size() > 10 && parts.size() <= 200, "not more than a bar can show");
        QVERIFY(std::ranges::is_sorted(parts));
        QCOMPARE(parts.front(), 0.5);
        QCOMPARE(parts.back(), 1.0);
    }

    void cancelledItGivesWhatThereIs()
    {
        WorkAside aside;
        Held held;
        int value = 0;
        aside.start(
            held, [&](int made) { value = made; }, kNobody);
        held.begun->acquire();
        aside.cancel();
        QVERIFY(aside.isRunning());
        AWAIT(!aside.isRunning());
        QCOMPARE(value, -1);
        aside.cancel(); // nothing: it may be asked at any time
        aside.drop();
        aside.start(
            Held{held.begun, held.letThrough, 3}, [&](int made) { value = made; }, kNobody);
        held.letThrough->release();
        AWAIT_COMPARE(value, 3); // the next one is not stopped
    }

    void cancelledBeforeItBeginsItSeesThat()
    {
        Held held;
        std::vector<std::unique_ptr<WorkAside>> before;
        for (int i = 0; i < QThreadPool::globalInstance()->maxThreadCount(); ++i) {
            before.push_back(std::make_unique<WorkAside>(WorkAside::Kind::OfAnEdit));
            before.back()->start(
                held, [](int) {}, kNobody);
            held.begun->acquire();
        }
        WorkAside aside(WorkAside::Kind::OfAnEdit); // has to wait
        bool wasStopped = false;
        aside.start([](const Stop &stop, const Progress &) { return stop.stop_requested(); },
                    [&](bool stopped) { wasStopped = stopped; }, kNobody);
        aside.cancel();
        held.letThrough->release(static_cast<int>(before.size()));
        AWAIT(!aside.isRunning());
        QVERIFY(wasStopped);
    }

    void droppedItCallsNobody()
    {
        WorkAside aside;
        QSignalSpy running(&aside, &WorkAside::runningChanged);
        Held held;
        connect(&aside, &WorkAside::progressed, this, [] { QFAIL("nobody listens any more"); });
        aside.start(
            [held](const Stop &stop, const Progress &progress) {
                held(stop, progress);
                progress(1.0);
                return 0;
            },
            kNobody, kNobody);
        held.begun->acquire();
        aside.drop();
        QVERIFY(!aside.isRunning());
        finishAside();
        QCOMPARE(QList<QVariantList>(running), kOnceOnAndOff);
    }

    void theLastWorkIsTheOneThatCounts()
    {
        WorkAside aside;
        QSignalSpy running(&aside, &WorkAside::runningChanged);
        Held first;
        aside.start(first, kNobody, kNobody);
        first.begun->acquire();
        int value = 0;
        aside.start([](const Stop &, const Progress &) { return 2; }, [&](int made) { value = made; }, kNobody);
        finishAside();
        QCOMPARE(value, 2);
        QCOMPARE(QList<QVariantList>(running), kOnceOnAndOff);
    }

    void oneMayFollowTheOther()
    {
        WorkAside aside;
        QSignalSpy running(&aside, &WorkAside::runningChanged);
        const auto work = [](const Stop &, const Progress &) { return 1; };
        int done = 0;
        aside.start(
            work,
            [&](int) {
                aside.start(
                    work, [&](int made) { done = made; }, kNobody);
            },
            kNobody);
        AWAIT(!aside.isRunning());
        QCOMPARE(done, 1);
        QCOMPARE(QList<QVariantList>(running), kOnceOnAndOff);
    }

    void whoAskedMayBeGone()
    {
        Held held;
        std::atomic<bool> ended = false;
        const auto kept = std::make_shared<int>();
        auto aside = std::make_unique<WorkAside>();
        connect(aside.get(), &WorkAside::runningChanged, this, [](bool running) { QVERIFY(running); });
        aside->start(
            [held, &ended](const Stop &stop, const Progress &progress) {
                held(stop, progress);
                ended = true;
                return 0;
            },
            [kept](int) { QFAIL("is not to be called"); }, kNobody);
        held.begun->acquire();
        aside.reset();                  // stops it
        QCOMPARE(kept.use_count(), 1L); // what was to be called went at once, in this thread
        finishAside();
        QVERIFY2(ended, "the application waits at its end as this does");
    }

    void whoAskedMayGoWhenItIsDone()
    {
        auto *aside = new WorkAside;
        bool gone = false;
        connect(aside, &QObject::destroyed, this, [&] { gone = true; });
        aside->start([](const Stop &, const Progress &) { return 1; }, [&](int) { delete aside; }, kNobody);
        AWAIT(gone);
    }

    void whatIsThrownBecomesASentence_data()
    {
        QTest::addColumn<bool>("isMemory");
        QTest::addColumn<QString>("said");
        QTest::newRow("no memory") << true
                                   << "There is not enough memory for that: try fewer steps, or a smaller file.";
        QTest::newRow("another") << false << "That failed: so it is.";
    }

    void whatIsThrownBecomesASentence()
    {
        QFETCH(const bool, isMemory);
        WorkAside aside;
        QString sentence;
        QThread *here = nullptr;
        aside.start(
            [isMemory](const Stop &, const Progress &) -> int {
                if (isMemory) {
                    throw std::bad_alloc();
                }
                throw std::runtime_error("so it is");
            },
            kNobody,
            [&](const QString &problem) {
                here = QThread::currentThread();
                sentence = problem;
            });
        AWAIT(!aside.isRunning());
        QTEST(sentence, "said");
        QCOMPARE(here, thread());
    }

    /// Of what lasts, more than there are processors; an edit's computation comes through all the same.
    void noEditWaitsBehindWhatLasts()
    {
        std::vector<std::unique_ptr<WorkAside>> lasting;
        for (int i = 0; i <= 2 * QThread::idealThreadCount(); ++i) {
            Held held;
            lasting.push_back(std::make_unique<WorkAside>());
            lasting.back()->start(held, kNobody, kNobody);
            held.begun->acquire(); // it does not wait for the others either
        }
        Session session;
        Sampling sampling;
        sampling.steps = 400'000;
        SolverSettings solver = session.solver();
        solver.method = Method::Newton;
        session.setSolver(solver);
        QSignalSpy busy(&session, &Session::busyChanged);
        session.setSampling(sampling);
        QCOMPARE(busy.count(), 1); // aside
        AWAIT_COMPARE(session.result()->sampling, sampling);
        for (const std::unique_ptr<WorkAside> &work : lasting) {
            QVERIFY(work->isRunning());
        }
        lasting.clear();
        finishAside();
    }
};

QTEST_GUILESS_MAIN(tst_work_aside)
#include "tst_work_aside.moc"
