// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/diagnosis.h"

namespace slidercrank
{

std::shared_ptr<const Diagnosis> diagnose(const std::shared_ptr<const Reference> &reference, const Mechanism &mechanism,
                                          std::stop_token stop)
{
    auto diagnosis = std::make_shared<Diagnosis>();
    diagnosis->reference = reference;
    diagnosis->parameters = mechanism.parameters();
    diagnosis->found = interpret(reference->data, mechanism, stop);
    if (stop.stop_requested()) {
        return nullptr;
    }
    return diagnosis;
}

} // namespace slidercrank
