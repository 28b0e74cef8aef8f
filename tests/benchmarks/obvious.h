#pragma once

#include <memory>

namespace fumage::benchmarks {

/// The obvious program of the 2012 model, for one setting of the compiler.
class Obvious2012 {
public:
    virtual ~Obvious2012() = default;
    virtual void step() = 0;
};

/// gcc -O3 for baseline x86-64.
[[nodiscard]] std::unique_ptr<Obvious2012> makeObvious2012(int particles);
/// The same with -march=native.
[[nodiscard]] std::unique_ptr<Obvious2012> makeObvious2012Native(int particles);

} // namespace fumage::benchmarks
