#pragma once

#include "ui/document/document.h"

#include <QElapsedTimer>
#include <QPointer>

class QAction;
class QWindow;

namespace fumage::ui {

class ActionSet;
class Viewport;

/// The document (A) beside a scene that was put aside (B): both side by side, or B alone. The key of B switches when
/// it is tapped, and shows B for a moment when it is held. B is the document as it was opened until another is put
/// aside.
class Comparison : public QObject {
    Q_OBJECT

public:
    /// A key that is down for longer than this was held, not tapped.
    static constexpr qint64 kTapMs = 300;

    Comparison(Document& document, Viewport& viewport, const ActionSet& actions);

    [[nodiscard]] const Scene& other() const { return m_other; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setReference();
    void show();
    void beginHold();
    void endHold();

    Document& m_document;
    Viewport& m_viewport;
    QAction& m_split;
    QAction& m_hold;
    Scene m_other;
    QElapsedTimer m_sincePress;
    QPointer<QWindow> m_heldIn; ///< the window that will see the key released; null while it is up
};

} // namespace fumage::ui
