// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The Newton-Raphson tab: settings and outcome of the solver, and the equations, Jacobian, iterations and coordinates at
// the current time.

#include "ui/document/result.h"
#include "ui/panels/page.h"
#include "ui/panels/segmented_pages.h"

#include <memory>

namespace slidercrank
{

class SolverForm;
class TablePanel;

class NewtonPanel : public SegmentedPages
{
    Q_OBJECT

public:
    explicit NewtonPanel(QWidget *parent = nullptr);

public slots:
    /// Shows the settings and emits nothing.
    void setSolver(const slidercrank::SolverSettings &solver);
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);
    void setPose(const slidercrank::Pose &pose);

signals:
    void edited(const slidercrank::SolverSettings &solver);
    void rowsCopied(int count);
    void partHovered(slidercrank::MechanismPart part);
    void problemFound(const QString &sentence);

private:
    Page page() const;

    std::shared_ptr<const Result> m_result;
    double m_time = 0.0;
    SolverForm *m_form;
    TablePanel *m_tables;
};

} // namespace slidercrank
