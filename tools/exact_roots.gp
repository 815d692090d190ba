\\ Writes the table of exact roots that the stability of the root finder is measured by.
\\ Usage: gp -q tools/exact_roots.gp > sim/stability/exact_roots.txt
\\
\\ A line is a polynomial sum c_i u^i (1-u)^(n-i): family, bits of the coefficients, n, each c_i as
\\ mantissa and exponent of two, the number of real roots in [0, 1] and the roots, multiple ones
\\ repeated. The coefficients are exact, the roots those of the rounded coefficients.

default(realprecision, 50);
setrand(1984);

k_cases = 40;

uniform(low, high) = low + (high - low) * random(2^40) / 2^40;
magnitude(low, high) = bestappr(exp(uniform(log(low), log(high))), 10^40);

\\ x rounded to so many bits, as [mantissa, exponent].
rounded(x, bits) =
{
  if (x == 0, return([0, 0]));
  my(e = logint(floor(abs(x) * 2^200), 2) - 200 - bits + 1);
  [round(x / 2^e), e];
}

value(m) = m[1] * 2^m[2];

\\ c as a polynomial in u, and back.
power_form(c) = my(n = #c - 1); sum(i = 0, n, c[i + 1] * 'u^i * (1 - 'u)^(n - i));
terms(p, n) =
{
  my(q = sum(i = 0, poldegree(p), polcoef(p, i) * 'u^i * (1 + 'u)^(n - i)));
  vector(n + 1, i, polcoef(q, i - 1));
}

write_case(family, bits, c) =
{
  my(m = apply(x -> rounded(x, bits), c), p = power_form(apply(value, m)), roots = []);
  if (p != 0, roots = vecsort(polrootsreal(p, [0, 1])));
  printf("%s %d %d", family, bits, #c - 1);
  for (i = 1, #m, printf(" %d %d", m[i][1], m[i][2]));
  printf(" %d", #roots);
  for (i = 1, #roots, printf(" %s", strjoin(strsplit(strprintf("%.21e", roots[i]), " "))));
  print();
}

factor_at(r) = 'u - r;
random_terms(n) = vector(n + 1, i, uniform(-1, 1));
random_polynomial(n) = power_form(random_terms(n));
\\ Without a root in [0, 1].
positive_polynomial(n) = power_form(vector(n + 1, i, uniform(1/8, 1)));
dyadic() = (1 + random(15)) / 16;

\\ A section of a vase (r, z) and the equation of a ray that passes the axis at distance h with the
\\ slope a of height over way, way 0 at height 0: z^2 - a^2 (r^2 - h^2).
vase_radius = power_form([2/5, 3 * 9/10, 3 * 4/5, 3/5]);
vase_height = power_form([-1/2, -3 * 1/5, 3 * 1/4, 1/2]);
ray_equation(a, h, height) = (vase_height - height)^2 - a^2 * (vase_radius^2 - h^2);
widest_at = bestappr(polrootsreal(deriv(vase_radius), [0, 1])[1], 10^40);
widest = subst(vase_radius, 'u, widest_at);

generate(bits) =
{
  for (i = 1, k_cases,
    write_case("random", bits, random_terms(1 + i % 8));
    write_case("sextic", bits, random_terms(6));
    my(r = uniform(1/20, 19/20), gap = 10^(-3 - i % 10));
    write_case("cluster", bits, terms(factor_at(r) * factor_at(r + gap) * random_polynomial(4), 6));
    write_case("triple_cluster", bits,
               terms(factor_at(r) * factor_at(r + gap) * factor_at(r - gap) * random_polynomial(3), 6));
    my(sign = (-1)^i);
    write_case("double", bits, sign * terms(factor_at(dyadic())^2 * factor_at(dyadic()), 6));
    write_case("triple", bits, sign * terms(factor_at(dyadic())^3 * factor_at(dyadic()), 6));
    write_case("grazing", bits,
               terms(ray_equation(uniform(1/2, 4), widest * (1 + (-1)^i * 10^(-(i % 17))),
                                subst(vase_height, 'u, widest_at)), 6));
    write_case("ordinary", bits, terms(ray_equation(magnitude(1/4, 4), uniform(0, 1), uniform(-1, 1)), 6));
    write_case("flat_ray", bits, terms(ray_equation(magnitude(10^-6, 1/4), uniform(0, 4/5), uniform(-2/5, 2/5)), 6));
    my(ends = [factor_at(0), factor_at(1), factor_at(1/2), factor_at(0) * factor_at(1),
               factor_at(0) * factor_at(1/2) * factor_at(1), factor_at(0)^2, factor_at(1)^2, factor_at(1/2)^2]);
    write_case("ends", bits, sign * terms(ends[1 + i % 8] * power_form(vector(4, k, random(31) - 15)), 6));
    write_case("degree_drop", bits,
               terms(random_polynomial(3), 6) + vector(7, k, uniform(-1, 1) * 10^(-10 - i % 7)));
    write_case("no_root", bits,
               vector(7, k, if (k % 2, 1, -uniform(1/100, 7/8))));
    write_case("wide", bits, vector(7, k, (-1)^random(2) * magnitude(10^-12, 10^12)));
  );
  write_case("zero", bits, vector(7, k, 0));
};

generate(24);
generate(53);
quit
