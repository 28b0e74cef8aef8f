#pragma once

#include "ui/document/solo.h"

#include <QFrame>

class QLabel;

namespace fumage::ui {

/// A line over the viewport that says which layers are looked at alone, with a button that ends it; there only while
/// some are.
class SoloLine : public QFrame {
    Q_OBJECT

public:
    SoloLine(const Document& document, Solo& solo, QWidget* parent);

    /// Whether nobody is to see it for now.
    void setAway(bool away);
    [[nodiscard]] QString text() const;

private:
    void follow();

    const Document& m_document;
    const Solo& m_solo;
    QLabel* m_label;
    bool m_isAway = false;
};

} // namespace fumage::ui
