#pragma once

#include "core/effect/variation.h"

#include <QObject>
#include <QSet>

namespace fumage::ui {

/// Parameters that random changes leave alone.
class Locks : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] bool contains(const Parameter& parameter) const { return m_keys.contains(toKey(parameter)); }
    /// Whether a random change may touch a parameter: it makes the character of the smoke and is not locked.
    [[nodiscard]] bool mayVary(const Parameter& parameter) const
    {
        return isCharacter(parameter) && !contains(parameter);
    }
    void set(const Parameter& parameter, bool locked)
    {
        locked ? static_cast<void>(m_keys.insert(toKey(parameter)))
               : static_cast<void>(m_keys.remove(toKey(parameter)));
        emit changed();
    }

signals:
    void changed();

private:
    static QByteArray toKey(const Parameter& parameter)
    {
        return QByteArray(parameter.key.data(), static_cast<qsizetype>(parameter.key.size()));
    }

    QSet<QByteArray> m_keys;
};

} // namespace fumage::ui
