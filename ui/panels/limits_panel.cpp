// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/limits_panel.h"

#include "ui/panels/design_form.h"
#include "ui/text/finding_text.h"
#include "ui/widgets/named.h"

#include <QMenu>
#include <QScrollArea>

namespace slidercrank
{

LimitsPanel::LimitsPanel(QWidget *values, QWidget *parent)
    : SegmentedPages(QStringLiteral("limitsSegment"), parent)
    , m_response(new ResponseView)
    , m_design(new DesignForm)
{
    named("limits", this, tr("Motion limits"));
    addPage(tr("Values"), values);
    addPage(tr("Response"), m_response);
    auto *design = new QScrollArea; // for small screens
    design->setFrameShape(QFrame::NoFrame);
    design->setFocusPolicy(Qt::NoFocus);
    design->setWidgetResizable(true);
    design->setWidget(m_design);
    addPage(tr("Design"), design);
}

void LimitsPanel::setResult(const std::shared_ptr<const Result> &result)
{
    m_response->setResult(result);
    m_design->setResult(*result);
}

void LimitsPanel::showResponse(Parameter parameter)
{
    m_response->setParameter(parameter);
    setCurrent(1);
    emit responseShown();
}

void LimitsPanel::fillMenu(QMenu *menu)
{
    for (const Parameter parameter : kVariedParameters) {
        menu->addAction(symbolOf(parameter), this, [this, parameter] { showResponse(parameter); });
    }
}

} // namespace slidercrank
