#pragma once

#include "editor_helpers.h"

#include "ui/document/solo.h"
#include "ui/panels/effect_panel.h"
#include "ui/panels/number_field.h"

#include <memory>

namespace fumage::tests {

/// The panel of the effect with all its groups open, on a document of its own for each test; without a window around
/// it.
class PanelFixture : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup();

protected:
    /// A field by its objectName; it must be there.
    [[nodiscard]] NumberField* field(const char* name) const;
    static void typeInto(NumberField& field, const QString& text);

    std::unique_ptr<Document> m_document;
    std::unique_ptr<Locks> m_locks;
    std::unique_ptr<Solo> m_solo;
    std::unique_ptr<EffectPanel> m_panel;
};

} // namespace fumage::tests
