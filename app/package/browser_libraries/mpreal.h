// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The part of MPFR C++ that the program uses, for a browser, where there is no MPFR: numbers of Boost.Multiprecision.

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace mpfr
{

class mpreal
{
public:
    /// The precision is always that of Number.
    mpreal(double value = 0.0, int /*bits*/ = 0)
        : m_number(value)
    {
    }

    explicit operator double() const { return static_cast<double>(m_number); }

    mpreal &operator+=(const mpreal &other) { return m_number += other.m_number, *this; }
    mpreal &operator-=(const mpreal &other) { return m_number -= other.m_number, *this; }
    mpreal &operator*=(const mpreal &other) { return m_number *= other.m_number, *this; }
    mpreal &operator/=(const mpreal &other) { return m_number /= other.m_number, *this; }
    mpreal operator-() const { return mpreal(Number(-m_number)); }

    friend mpreal operator+(mpreal x, const mpreal &y) { return x += y; }
    friend mpreal operator-(mpreal x, const mpreal &y) { return x -= y; }
    friend mpreal operator*(mpreal x, const mpreal &y) { return x *= y; }
    friend mpreal operator/(mpreal x, const mpreal &y) { return x /= y; }

    friend bool operator<(const mpreal &x, const mpreal &y) { return x.m_number < y.m_number; }
    friend bool operator>(const mpreal &x, const mpreal &y) { return x.m_number > y.m_number; }
    friend bool operator<=(const mpreal &x, const mpreal &y) { return x.m_number <= y.m_number; }
    friend bool operator>=(const mpreal &x, const mpreal &y) { return x.m_number >= y.m_number; }

    friend mpreal abs(const mpreal &x) { return mpreal(Number(abs(x.m_number))); }
    friend mpreal sqrt(const mpreal &x) { return mpreal(Number(sqrt(x.m_number))); }
    friend mpreal sin(const mpreal &x) { return mpreal(Number(sin(x.m_number))); }
    friend mpreal cos(const mpreal &x) { return mpreal(Number(cos(x.m_number))); }
    friend mpreal acos(const mpreal &x) { return mpreal(Number(acos(x.m_number))); }
    friend mpreal atan2(const mpreal &y, const mpreal &x) { return mpreal(Number(atan2(y.m_number, x.m_number))); }

private:
    using Number =
        boost::multiprecision::number<boost::multiprecision::cpp_bin_float<384, boost::multiprecision::digit_base_2>,
                                      boost::multiprecision::et_off>;

    explicit mpreal(const Number &number)
        : m_number(number)
    {
    }

    Number m_number;
};

} // namespace mpfr

inline void mpfr_free_cache() {}
