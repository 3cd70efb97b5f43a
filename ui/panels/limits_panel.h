// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Motion limits: their values, how they depend on a parameter, and the design of a mechanism for a stroke and a time
// ratio.

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
    /// `values`: the page of limitsPage().
    explicit LimitsPanel(QWidget *values, QWidget *parent = nullptr);

    void setResult(const std::shared_ptr<const Result> &result);

    /// Brings the response to one of kVariedParameters to the front; responseShown() follows.
    void showResponse(Parameter parameter);

    /// The actions that do so.
    void fillMenu(QMenu *menu);

signals:
    void edited(const slidercrank::Parameters &parameters);
    void parameterRequested(slidercrank::Parameter parameter, double value);
    void dragBegan();
    void dragEnded();
    void responseShown();
    void copied(const QString &sentence);
    void problemFound(const QString &sentence);

private:
    ResponseView *m_response;
    DesignForm *m_design;
};

} // namespace slidercrank
