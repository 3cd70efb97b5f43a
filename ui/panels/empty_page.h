// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets/named.h"
#include "ui/widgets/paragraph.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QPushButton>

namespace slidercrank
{

struct EmptyPage {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::EmptyPage)
};

/// What a panel shows while there is no reference: what for one is opened, and buttons that open one.
template <typename Panel>
QWidget *emptyPage(Panel *panel, const QString &purpose)
{
    auto *text = new Paragraph(purpose);
    text->setAlignment(Qt::AlignCenter);
    auto *openReference = named("openReferenceButton", new QPushButton(EmptyPage::tr("Open reference…")));
    auto *openSample = named("openSampleButton", new QPushButton(EmptyPage::tr("Open the sample")));
    openSample->setToolTip(EmptyPage::tr("The motion that the report's author exported from Inventor"));
    QObject::connect(openReference, &QPushButton::clicked, panel, &Panel::openReferenceRequested);
    QObject::connect(openSample, &QPushButton::clicked, panel, &Panel::openSampleRequested);

    auto *buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(openReference);
    buttons->addWidget(openSample);
    buttons->addStretch(1);
    auto *page = new QWidget;
    auto *rows = new QVBoxLayout(page);
    rows->addStretch(1);
    rows->addWidget(text);
    rows->addLayout(buttons);
    rows->addStretch(1);
    return page;
}

} // namespace slidercrank
