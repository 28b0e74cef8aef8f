#include "ui/viewport/readout.h"

#include "ui/document/number_text.h"

#include <QPainter>

namespace fumage::ui {

void Readout::count()
{
    if (m_sinceLast.isValid()) {
        constexpr double kShareOfNewest = 0.15;
        constexpr double kNanosecondsAMillisecond = 1e6;
        const double ms = static_cast<double>(m_sinceLast.nsecsElapsed()) / kNanosecondsAMillisecond;
        constexpr double kLongestMs = 1500.0; // between frames that follow one another
        if (ms > kLongestMs) {
            restart();
        } else {
            m_intervalMs = m_intervalMs == 0.0 ? ms : m_intervalMs + (ms - m_intervalMs) * kShareOfNewest;
        }
    }
    m_sinceLast.start();
}

void Readout::paint(QPainter& painter, const Picture& picture, bool rate, int height) const
{
    const auto ms = [](std::chrono::nanoseconds time) {
        return formatFixed(std::chrono::duration<double, std::milli>(time).count(), 1);
    };
    QStringList figures;
    if (rate && m_intervalMs > 0.0) {
        figures += tr("%1 fps").arg(1000.0 / m_intervalMs, 0, 'f', 0);
    }
    figures += tr("%1 particles").arg(picture.particles);
    if (picture.coarseAir) {
        figures += tr("coarse air");
    }
    constexpr qint64 kWorthTelling = 10'000'000;
    if (picture.bakeNs > kWorthTelling) {
        figures +=
            tr("air %1 s")
                .arg(formatFixed(std::chrono::duration<double>(std::chrono::nanoseconds(picture.bakeNs)).count(), 2));
    }
    figures += tr("step %1 ms").arg(ms(std::chrono::nanoseconds(picture.stepNs)));
    figures += tr("light %1 ms").arg(ms(picture.times.light + picture.times.sprites));
    figures += tr("composite %1 ms").arg(ms(picture.times.composite));
    const QString text = figures.join(QStringLiteral("   "));
    painter.setPen(QColor(0, 0, 0, 170));
    painter.drawText(QPointF(13.0, height - 11.0), text);
    painter.setPen(QColor(225, 230, 238, 200));
    painter.drawText(QPointF(12.0, height - 12.0), text);
}

} // namespace fumage::ui
