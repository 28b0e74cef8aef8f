#pragma once

#include "ui/preview/picture.h"

#include <QCoreApplication>
#include <QElapsedTimer>

class QPainter;

namespace fumage::ui {

/// The figures in the corner of the viewport: how often pictures come, and what they cost.
class Readout {
    Q_DECLARE_TR_FUNCTIONS(Readout)

public:
    /// A picture has come.
    void count();
    /// Forgets how often pictures came.
    void restart() { m_intervalMs = 0.0; }
    /// @param rate whether to say how often pictures come
    void paint(QPainter& painter, const Picture& picture, bool rate, int height) const;

private:
    QElapsedTimer m_sinceLast;
    double m_intervalMs = 0.0; ///< between pictures, smoothed; 0: not known
};

} // namespace fumage::ui
