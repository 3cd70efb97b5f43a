// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab of the motion limits: their values, their response to a parameter, and the design of a mechanism for a given
// stroke and time ratio.

#include "ui/panels/response_view.h"
#include "ui/panels/segmented_pages.h"

class QMenu;

namespace slidercrank
{

class DesignForm;

class LimitsPanel : public SegmentedPages
{
    Q_OBJECT

public:
    /// `values`: the panel that shows limitsPage().
    explicit LimitsPanel(QWidget *values, QWidget *parent = nullptr);

    void setResult(const std::shared_ptr<const Result> &result);

    ResponseView *response() const { return m_response; }
    DesignForm *design() const { return m_design; }

    /// Shows the response to one of kVariedParameters and emits responseShown().
    void showResponse(Parameter parameter);

    /// Adds an action for each of these parameters to the menu.
    void fillMenu(QMenu *menu);

signals:
    void responseShown();

private:
    ResponseView *m_response;
    DesignForm *m_design;
};

} // namespace slidercrank
