// SPDX-License-Identifier: GPL-3.0-or-later

// Tells the thread sanitizer how Qt synchronizes threads, which it cannot see because Qt's libraries are not compiled
// with it. Covers the functions that the program uses: those below replace Qt's functions of the same names. Linked
// only in builds with the thread sanitizer.

#include <QFutureInterface>
#include <QMetaObject>
#include <QRunnable>
#include <QThreadPool>

#include <sanitizer/tsan_interface.h>

#include <dlfcn.h>
#include <sched.h>

#include <cstdarg>
#include <functional>
#include <utility>

namespace
{

char taskEndTag; // the address at which the sanitizer synchronizes the end of tasks with waiting for them

/// A task that synchronizes the two threads for the sanitizer.
class Handed : public QRunnable
{
public:
    explicit Handed(std::function<void()> work)
        : m_work(std::move(work))
    {
        __tsan_release(this);
    }

    __attribute__((no_sanitize("thread"))) void run() override
    {
        __tsan_acquire(this);
        m_work();
        m_work = nullptr;
        __tsan_release(&taskEndTag);
    }

private:
    std::function<void()> m_work;
};

/// A slot that synchronizes the calling and the called thread for the sanitizer.
class HandedSlot : public QtPrivate::QSlotObjectBase
{
public:
    explicit HandedSlot(QSlotObjectBase *slot)
        : QSlotObjectBase(&HandedSlot::doIt)
        , m_slot(slot)
    {
        __tsan_release(this);
    }

private:
    __attribute__((no_sanitize("thread"))) static void doIt(int what, QSlotObjectBase *self, QObject *receiver,
                                                            void **arguments, bool *)
    {
        auto *const handed = static_cast<HandedSlot *>(self);
        __tsan_acquire(handed);
        if (what == Call) {
            handed->m_slot->call(receiver, arguments);
            __tsan_release(handed);
        } else if (what == Destroy) {
            handed->m_slot->destroyIfLastRef();
            delete handed;
        }
    }

    QSlotObjectBase *m_slot;
};

} // namespace

/// Allows tests to fork while other threads run, for children that are killed or reach a resource limit.
extern "C" const char *__tsan_default_options()
{
    return "die_after_fork=0";
}

/// Gives the child of QProcess its own memory. QProcess otherwise shares the parent's memory until exec(), and the
/// sanitizer would then take the parent for the child.
extern "C" int clone(int (*function)(void *), void *stack, int flags, void *argument, ...) noexcept
{
    using Clone = int (*)(int (*)(void *), void *, int, void *, ...);
    static const auto real = reinterpret_cast<Clone>(dlsym(RTLD_NEXT, "clone"));
    std::va_list more;
    va_start(more, argument);
    auto *const parentsName = va_arg(more, void *);
    auto *const threadsOwn = va_arg(more, void *);
    auto *const childsName = va_arg(more, void *);
    va_end(more);
    return real(function, stack, flags & ~(CLONE_VM | CLONE_VFORK), argument, parentsName, threadsOwn, childsName);
}

static void startHanded(QThreadPool *pool, std::function<void()> work, int priority)
{
    using Start = void (*)(QThreadPool *, QRunnable *, int);
    static const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "_ZN11QThreadPool5startEP9QRunnablei"));
    start(pool, new Handed(std::move(work)), priority);
}

void QThreadPool::start(std::function<void()> work, int priority)
{
    startHanded(this, std::move(work), priority);
}

/// QtConcurrent::run() calls this overload.
void QThreadPool::start(QRunnable *runnable, int priority)
{
    const auto work = [runnable] {
        const bool isOwned = runnable->autoDelete();
        runnable->run();
        if (isOwned) {
            delete runnable;
        }
    };
    startHanded(this, work, priority);
}

void QFutureInterfaceBase::reportFinished()
{
    using Report = void (*)(QFutureInterfaceBase *);
    static const auto report =
        reinterpret_cast<Report>(dlsym(RTLD_NEXT, "_ZN20QFutureInterfaceBase14reportFinishedEv"));
    __tsan_release(&taskEndTag);
    report(this);
}

void QFutureInterfaceBase::waitForResult(int index)
{
    using Wait = void (*)(QFutureInterfaceBase *, int);
    static const auto wait = reinterpret_cast<Wait>(dlsym(RTLD_NEXT, "_ZN20QFutureInterfaceBase13waitForResultEi"));
    wait(this, index);
    __tsan_acquire(&taskEndTag);
}

bool QThreadPool::waitForDone(int milliseconds)
{
    using Wait = bool (*)(QThreadPool *, int);
    static const auto wait = reinterpret_cast<Wait>(dlsym(RTLD_NEXT, "_ZN11QThreadPool11waitForDoneEi"));
    const bool isDone = wait(this, milliseconds);
    __tsan_acquire(&taskEndTag);
    return isDone;
}

bool QMetaObject::invokeMethodImpl(QObject *object, QtPrivate::QSlotObjectBase *slot, Qt::ConnectionType type,
                                   void *ret)
{
    using Invoke = bool (*)(QObject *, QtPrivate::QSlotObjectBase *, Qt::ConnectionType, void *);
    static const auto invoke = reinterpret_cast<Invoke>(
        dlsym(RTLD_NEXT,
              "_ZN11QMetaObject16invokeMethodImplEP7QObjectPN9QtPrivate15QSlotObjectBaseEN2Qt14ConnectionTypeEPv"));
    return invoke(object, new HandedSlot(slot), type, ret);
}
