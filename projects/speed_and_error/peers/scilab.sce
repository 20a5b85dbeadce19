// The chain of James (2021), eqs. (31)-(32), with Scilab's default ode, for scilab_chain.py.
// Reads its parameters from the environment and writes little-endian doubles: wall-clock and processor
// seconds, then the final state (x_1 .. x_N, w_1 .. w_N).
mode(-1);

gam = strtod(getenv("CHAIN_GAMMA"));
left = strtod(getenv("CHAIN_LEFT"));
N = strtod(getenv("CHAIN_BEADS"));
t_end = strtod(getenv("CHAIN_END"));
rtol = strtod(getenv("CHAIN_RTOL"));
atol = strtod(getenv("CHAIN_ATOL"));

function dy = chain(t, y)
    x = y(1:N);
    w = y(N+1:2*N);
    u = [left; x(1:N-1) - x(2:N); 0];
    force = max(u, 0).^1.5;
    dw = force(1:N) - force(2:N+1);
    dy = [w + gam*dw; dw];
endfunction

fd = mopen(getenv("CHAIN_START"), "rb");
y0 = mget(2*N, "dl", fd)';
mclose(fd);

// The default stops after 500 steps between two output times.
%ODEOPTIONS = [1, 0, 0, %inf, 0, 2, 10000000, 12, 5, 0, -1, -1];
timer();
tic();
y = ode(y0, 0, t_end, rtol, atol, chain);
seconds = toc();
cpu_seconds = timer();

fd = mopen(getenv("CHAIN_OUTPUT"), "wb");
mput([seconds; cpu_seconds; y], "dl", fd);
mclose(fd);
quit
