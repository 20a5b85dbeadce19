// The chain of James (2021), eqs. (31)-(32), with Scilab's default ode, for workflow/scripts/peers/chain.py.
// Reads its parameters from the environment and writes little-endian doubles:
// seconds, right-hand sides, then the final state (x_1 .. x_N, w_1 .. w_N).
mode(-1);

gam = strtod(getenv("CHAIN_GAMMA"));
delta = strtod(getenv("CHAIN_DELTA"));
N = strtod(getenv("CHAIN_BEADS"));
t_end = strtod(getenv("CHAIN_END"));
rtol = strtod(getenv("CHAIN_RTOL"));
atol = strtod(getenv("CHAIN_ATOL"));
repeats = strtod(getenv("CHAIN_REPEATS"));

function dy = chain(t, y)
    x = y(1:N);
    w = y(N+1:2*N);
    u = [delta; x(1:N-1) - x(2:N); 0];
    force = max(u, 0).^1.5;
    dw = force(1:N) - force(2:N+1);
    dy = [w + gam*dw; dw];
endfunction

// The default stops after 500 steps between two output times.
%ODEOPTIONS = [1, 0, 0, %inf, 0, 2, 10000000, 12, 5, 0, -1, -1];
y0 = zeros(2*N, 1);
y0(N+1) = -gam*delta^1.5;

best = %inf;
for k = 1:repeats
    tic();
    [y, rd, id] = ode(y0, 0, t_end, rtol, atol, chain);
    best = min(best, toc());
end

fd = mopen(getenv("CHAIN_OUTPUT"), "wb");
mput([best; id(12); y], "dl", fd);
mclose(fd);
quit
